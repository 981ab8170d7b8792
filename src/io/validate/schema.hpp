#pragma once

// What glTF's objects may hold, as tables (schema_core.cpp, schema_extensions.cpp), and the walk over a file by them
// (schema.cpp): types, ranges, what has to be there, references, extensions.

#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace facet::io::validate {

struct Asset;
struct Type;
using TypeOf = const Type& (*)();

enum class Kind : uint8_t {
  boolean,
  whole,
  number,
  text,
  object,
  index,
  numbers,  // arrays
  texts,    // that differ
  indices,  // that differ
  wholes,   // of which min and max of an accessor consist; checked there
  objects,
  indexMap,  // {"POSITION": 3}
  indexMaps,
  anything,
};

struct Field {
  std::string name;
  Kind kind = Kind::anything;
  bool isRequired = false;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool lowExcluded = false;
  double orElse = std::numeric_limits<double>::quiet_NaN();  // a value beside the range
  std::vector<double> values = {};                           // the only ones
  std::vector<std::string> words = {};                       // the only ones
  std::vector<size_t> lengths = {};                          // of an array
  std::string into = {};                                     // index: the collection; empty: not of the root
  bool marks = true;                                         // index: what it names is used
  TypeOf type = nullptr;                                     // object, objects
  std::string needs = {};                                    // another member

  Field required() &&;
  Field atLeast(double least) &&;
  Field above(double bound) &&;
  Field within(double least, double most) &&;
  Field oneOf(std::vector<double> numbers) &&;
  Field oneOf(std::vector<std::string> texts) &&;
  Field ofLength(std::vector<size_t> some) &&;
  Field with(std::string other) &&;
};

struct Type {
  std::string name;  // "material"; of an extension's object "KHR_materials_ior of material"
  std::vector<Field> fields;
};

// Null where the extension has no place there, or is not known.
const Type* extensionType(std::string_view name, std::string_view parent);
bool isKnownExtension(std::string_view name);  // its objects are checked

const Type& rootType();

// Walks asset.json: findings, asset.used, asset.extensionsSeen.
void checkSchema(Asset& asset);

}  // namespace facet::io::validate
