#pragma once

// What there is to choose from, one row each: options and their help, panel, names of programs and reports are derived
// from it.

#include <cstddef>
#include <string>
#include <string_view>

namespace facet {

template <class T>
struct Choice {
  T value;
  std::string_view word;       // on the command line and in files; empty where neither names it
  std::string_view label;      // for people
  std::string_view note = {};  // what it is, where the label does not say
};

// Row i is value i: the tables of enumerations are, and so in the order of the shader that reads the number.
template <class T, size_t count>
constexpr bool inOrder(const Choice<T> (&rows)[count]) {
  for (size_t i = 0; i < count; ++i)
    if (static_cast<size_t>(rows[i].value) != i) return false;
  return true;
}

template <class T, size_t count>
constexpr const Choice<T>& rowOf(const Choice<T> (&rows)[count], T value) {
  return rows[static_cast<size_t>(value)];
}

// The row of a word, null where there is none.
template <class T, size_t count>
constexpr const Choice<T>* rowOfWord(const Choice<T> (&rows)[count], std::string_view word) {
  for (const Choice<T>& row : rows)
    if (row.word == word) return &row;
  return nullptr;
}

// "lambert, burley, frostbite"
template <class T, size_t count>
std::string wordsOf(const Choice<T> (&rows)[count]) {
  std::string words;
  for (const Choice<T>& row : rows) words += (words.empty() ? "" : ", ") + std::string(row.word);
  return words;
}

}  // namespace facet
