#pragma once

// Rows of the schema's tables.

#include <utility>

#include "io/validate/schema.hpp"

namespace facet::io::validate {

inline Field Field::required() && {
  isRequired = true;
  return std::move(*this);
}
inline Field Field::atLeast(double least) && {
  low = least;
  return std::move(*this);
}
inline Field Field::above(double bound) && {
  low = bound;
  lowExcluded = true;
  return std::move(*this);
}
inline Field Field::within(double least, double most) && {
  low = least;
  high = most;
  return std::move(*this);
}
inline Field Field::oneOf(std::vector<double> numbers) && {
  values = std::move(numbers);
  return std::move(*this);
}
inline Field Field::oneOf(std::vector<std::string> texts) && {
  words = std::move(texts);
  return std::move(*this);
}
inline Field Field::ofLength(std::vector<size_t> some) && {
  lengths = std::move(some);
  return std::move(*this);
}
inline Field Field::with(std::string other) && {
  needs = std::move(other);
  return std::move(*this);
}

inline Field field(std::string name, Kind kind) { return {.name = std::move(name), .kind = kind}; }
inline Field boolean(std::string name) { return field(std::move(name), Kind::boolean); }
inline Field natural(std::string name) { return field(std::move(name), Kind::whole).atLeast(0); }
inline Field number(std::string name) { return field(std::move(name), Kind::number); }
inline Field text(std::string name) { return field(std::move(name), Kind::text); }
inline Field numbers(std::string name, size_t length) {
  return field(std::move(name), Kind::numbers).ofLength({length});
}
inline Field index(std::string name, std::string into) {
  Field row = field(std::move(name), Kind::index);
  row.into = std::move(into);
  return row;
}
inline Field indices(std::string name, std::string into) {
  Field row = field(std::move(name), Kind::indices);
  row.into = std::move(into);
  return row;
}
inline Field object(std::string name, TypeOf type) {
  Field row = field(std::move(name), Kind::object);
  row.type = type;
  return row;
}
inline Field objects(std::string name, TypeOf type) {
  Field row = field(std::move(name), Kind::objects);
  row.type = type;
  return row;
}

const Type& textureInfoType();
const Type& normalTextureInfoType();
const Type& occlusionTextureInfoType();

}  // namespace facet::io::validate
