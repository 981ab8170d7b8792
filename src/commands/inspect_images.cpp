#include <nlohmann/json.hpp>
#include <ostream>

#include "commands/inspect_parts.hpp"
#include "io/image.hpp"

namespace facet::commands {

nlohmann::ordered_json describeImages(const scene::Model& model, const std::vector<bool>& decoded) {
  auto out = nlohmann::ordered_json::array();
  const std::vector<io::ImageInfo> infos = io::describeImages(model);
  for (size_t i = 0; i < infos.size(); ++i) {
    const io::ImageInfo& info = infos[i];
    nlohmann::ordered_json image = {{"name", model.images[i].name}};
    if (info.problem.empty()) {
      image["format"] = info.format;
      image["width"] = info.width;
      image["height"] = info.height;
      image["channels"] = info.channels;
      image["bits"] = 8 * info.bytesPerSample;
      image["levels"] = info.levels;
    } else {
      image["problem"] = info.problem;
    }
    image["decoded"] = static_cast<bool>(decoded[i]);
    out.push_back(image);
  }
  return out;
}

void printImages(const nlohmann::ordered_json& images, std::ostream& out) {
  if (images.empty()) return;
  constexpr const char* channels[] = {"", "grey", "grey and alpha", "RGB", "RGBA"};
  out << "\nImages\n";
  for (const auto& image : images) {
    out << "  " << image["name"].get<std::string>() << ": ";
    if (image.contains("problem")) {
      out << image["problem"].get<std::string>();
    } else {
      const int levels = image["levels"].get<int>();
      out << image["format"].get<std::string>() << ", " << image["width"] << " x " << image["height"] << ", "
          << channels[image["channels"].get<size_t>()] << " of " << image["bits"] << " bits";
      if (levels > 1) out << ", " << levels << " mip levels";
    }
    out << (image["decoded"].get<bool>() ? "" : ", not decoded") << "\n";
  }
}

}  // namespace facet::commands
