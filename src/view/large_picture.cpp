#include "view/large_picture.hpp"

#include <sys/wait.h>

#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "base/child_program.hpp"
#include "base/process_pool.hpp"
#include "frame/settings.hpp"
#include "options/picture_options.hpp"

namespace facet::view {

namespace {

// The last line of what a process said, without its name.
std::string lastWords(const std::filesystem::path& file) {
  std::ifstream said(file);
  std::string line, last;
  while (std::getline(said, line))
    if (!line.empty()) last = line;
  for (const std::string_view prefix : {"facet: ", "error: "})
    if (last.starts_with(prefix)) last.erase(0, prefix.size());
  return last;
}

}  // namespace

LargePicture::~LargePicture() { cancel(); }

Result<void> LargePicture::start(const frame::PictureSettings& settings, const std::string& model,
                                 const std::filesystem::path& file) {
  cancel();
  std::vector<std::string> words = options::commandWords(settings, model, file.string());
  words.insert(words.begin(), ownProgram());
  file_ = file;
  said_ = file.parent_path() / ("." + file.filename().string() + ".said");
  const int process = startProgram(words, {.errors = said_.string()});
  if (process < 0)
    return fail(file.string(), "", std::string("no process can be started for it: ") + std::strerror(-process),
                "end other programs");
  process_ = process;
  return {};
}

std::optional<Result<std::string>> LargePicture::poll() {
  if (process_ <= 0) return std::nullopt;
  const std::optional<int> status = endedProgram(process_);
  if (!status) return std::nullopt;
  process_ = -1;
  const std::string words = lastWords(said_);
  std::error_code ignored;
  std::filesystem::remove(said_, ignored);
  if (WIFEXITED(*status) && WEXITSTATUS(*status) == 0) return Result<std::string>(file_.string());
  return Result<std::string>(
      tl::unexpected(Error{file_.string(), "", words.empty() ? "the process that drew it has ended" : words, {}}));
}

void LargePicture::cancel() {
  if (process_ <= 0) return;
  endProgram(std::exchange(process_, -1));
  std::error_code ignored;
  std::filesystem::remove(said_, ignored);
}

}  // namespace facet::view
