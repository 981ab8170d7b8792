#pragma once

// What the browser lists: built-ins, files in folders; and the search in it. No window.

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "view/file_kind.hpp"

namespace facet::view {

struct Entry {
  FileKind kind = FileKind::model;
  std::string source;  // an absolute path, or builtin:NAME
  std::string name;    // the file's
  std::string place;   // where it is, for people: "built-in", "recent", the folder below the one that is browsed

  bool operator==(const Entry&) const = default;
};

std::vector<Entry> builtinEntries();

// A file as it stands in a list; its place is its folder's name.
Entry fileEntry(FileKind kind, const std::filesystem::path& file);

struct ScanLimits {
  int depth = 6;        // folders below the one that is scanned
  int visited = 50000;  // files and folders looked at
  int listed = 5000;
};

struct FolderListing {
  std::filesystem::path folder;
  std::vector<Entry> entries;  // by path
  std::string problem;         // why it is empty or not whole; empty: nothing to say
};

// Every model, environment and measured BRDF below the folder. A folder is entered once, whatever links to it. A .bin
// is listed where its size is a UTIA database's: else it is some model's buffer.
FolderListing scanFolder(const std::filesystem::path& folder, const ScanLimits& limits = {},
                         const std::stop_token& stop = {});

// "chair.glb"; of a name that says nothing ("chair/scene.gltf"), with its folder's, and with that of the folder above
// where that says nothing either ("chair/glTF/model.gltf").
std::string fileName(const std::filesystem::path& file);

// "chair.glb"; of a name that says nothing ("chair/scene.gltf"), with its folder's, and with that of the folder above
// where that says nothing either ("chair/glTF/model.gltf").
std::string fileName(const std::filesystem::path& file);

// Every word of the query, in any case, is part of the text.
bool hasWords(std::string_view text, std::string_view query);

// The same of the entry's name and place.
bool matches(const Entry& entry, std::string_view query);

// Indices of the entries of that kind that match; of several with one source the first.
std::vector<int> filtered(const std::vector<Entry>& entries, FileKind kind, std::string_view query);

}  // namespace facet::view
