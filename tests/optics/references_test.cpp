// src/optics/references.bib: what comments and READMEs cite by name and year is there, and nothing else.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "report/sources.hpp"
#include "selftest/sources.hpp"

using namespace facet;

namespace {

namespace fs = std::filesystem;

const fs::path root = FACET_SOURCE_DIR;

std::string contentOf(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

// Of LaTeX or UTF-8 letters the plain ones; an umlaut may be written with an e.
std::string folded(std::string text) {
  const char* const letters[][2] = {{"á", "a"}, {"ä", "a"}, {"å", "a"}, {"à", "a"},    {"Å", "A"},    {"č", "c"},
                                    {"ć", "c"}, {"é", "e"}, {"í", "i"}, {"ñ", "n"},    {"ö", "o"},    {"ř", "r"},
                                    {"š", "s"}, {"ü", "u"}, {"ž", "z"}, {"\\AA", "A"}, {"\\aa", "a"}, {"\\o", "o"}};
  std::erase_if(text, [](char c) { return c == '{' || c == '}'; });
  for (const auto& [letter, plain] : letters) replaceAll(text, letter, plain);
  text = std::regex_replace(text, std::regex(R"(\\(['"`~^=.]|[vcuH] ))"), "");
  for (const char* const umlaut : {"ae", "oe", "ue"}) replaceAll(text, umlaut, {umlaut[0]});
  return text;
}

struct Reference {
  std::string type, key;
  std::map<std::string, std::string> fields;
  // The words of each author's name.
  std::vector<std::set<std::string>> authors;
};

std::set<std::string> namesIn(const std::string& text) {
  std::set<std::string> names;
  const std::regex word("[^ ,]+");
  for (std::sregex_iterator at(text.begin(), text.end(), word); at != std::sregex_iterator(); ++at)
    names.insert(at->str());
  return names;
}

// The value that begins with the brace at `at`, without its outer braces; `at` goes behind it.
std::string bracedValue(const std::string& text, size_t& at) {
  const size_t begin = at + 1;
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth == 0) break;
  }
  return text.substr(begin, at++ - begin);
}

std::vector<Reference> references() {
  std::vector<Reference> all;
  const std::string text = contentOf(root / "src/optics/references.bib");
  const std::regex head(R"(\n@(\w+)\{(\w+),)"), field(R"((\w+) = \{)");
  for (std::sregex_iterator entry(text.begin(), text.end(), head); entry != std::sregex_iterator(); ++entry) {
    size_t at = text.find('{', static_cast<size_t>(entry->position()));
    const std::string body = bracedValue(text, at);
    Reference& reference = all.emplace_back(Reference{(*entry)[1], (*entry)[2], {}, {}});
    std::smatch name;
    for (size_t i = 0; std::regex_search(body.begin() + static_cast<std::ptrdiff_t>(i), body.end(), name, field);) {
      i += static_cast<size_t>(name.position() + name.length()) - 1;
      reference.fields[name[1]] = bracedValue(body, i);
    }
    std::string authors = std::regex_replace(folded(reference.fields["author"]), std::regex(R"(\s+)"), " ");
    for (size_t end; !authors.empty(); authors.erase(0, end == std::string::npos ? end : end + 5)) {
      end = authors.find(" and ");
      reference.authors.push_back(namesIn(authors.substr(0, end)));
    }
  }
  return all;
}

struct Citation {
  std::vector<std::string> names;  // as they stand before the year: others than the authors may be the first ones
  bool others = false;             // "et al."
  std::string year;
};

bool isName(const std::string& word) {
  const auto lower = [](char c) { return (c >= 'a' && c <= 'z') || c < 0; };
  return word[0] >= 'A' && word[0] <= 'Z' && !std::strchr(".:;)", word.back()) &&
         std::any_of(word.begin() + 1, word.end(), lower);
}

// The names of a citation that ends at `end`, where its year begins: "Kulla and Conty ", "Walter et al. (".
Citation citationBefore(const std::string& text, size_t end, std::string year) {
  Citation citation{.names = {}, .others = false, .year = std::move(year)};
  bool last = false;
  while (!last) {
    while (end > 0 &&
           (text[end - 1] == ' ' || text[end - 1] == ',' || (citation.names.empty() && text[end - 1] == '(')))
      --end;
    size_t begin = end;
    while (begin > 0 && !std::strchr(" (\"`[*", text[begin - 1])) --begin;
    const std::string word = text.substr(begin, end - begin);
    last = begin == 0 || text[begin - 1] != ' ';
    end = begin;
    if (word == "al." || word == "et")
      citation.others = true;
    else if (word == "and" || word == "de" || word == "d'Eon")
      continue;
    else if (!word.empty() && isName(folded(word)))
      citation.names.insert(citation.names.begin(), folded(word));
    else
      break;
  }
  return citation;
}

// Comments and strings are read as if they had no line breaks.
std::vector<Citation> citationsIn(std::string text) {
  text = std::regex_replace(text, std::regex(R"(\n *(//)? *)"), " ");
  replaceAll(text, "\" \"", "");
  // Capital words before a year that are no names.
  const std::set<std::string> others = {"Since", "In", "Until", "Of"};
  std::vector<Citation> found;
  for (size_t i = 1; i + 4 <= text.size(); ++i) {
    if ((text[i - 1] != ' ' && text[i - 1] != '(') || (text.compare(i, 2, "19") != 0 && text.compare(i, 2, "20") != 0))
      continue;
    const auto digit = [&](size_t at) {
      return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
    };
    if (!digit(i + 2) || !digit(i + 3) || digit(i + 4) || text.compare(i, 4, "2029") > 0) continue;
    if (text.compare(i + 4, 2, " x") == 0) continue;  // a size
    const Citation citation = citationBefore(text, i, text.substr(i, 4));
    if (!citation.names.empty() && !others.contains(citation.names.back())) found.push_back(citation);
  }
  return found;
}

// Whether the names from some one on are the authors, the first of them first.
bool cites(const Citation& citation, const Reference& reference) {
  if (!reference.fields.contains("year") || reference.fields.at("year") != citation.year) return false;
  if (citation.others && reference.authors.size() < 3) return false;
  const auto isAuthor = [&](const std::string& name) {
    return std::ranges::any_of(reference.authors, [&](const auto& author) { return author.contains(name); });
  };
  for (auto first = citation.names.begin(); first != citation.names.end(); ++first)
    if (reference.authors.front().contains(*first) && std::all_of(first, citation.names.end(), isAuthor)) return true;
  return false;
}

std::string described(const Citation& citation) {
  std::string text;
  for (const std::string& name : citation.names) text += name + " ";
  return text + citation.year;
}

void addWords(const std::string& text, std::set<std::string>& words) {
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
      word += c;
    else if (!word.empty())
      words.insert(std::exchange(word, {}));
  }
}

std::vector<fs::path> writtenFiles() {
  std::vector<fs::path> files;
  for (const char* folder : {"src", "shaders"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
      if (std::set<std::string>{".cpp", ".hpp", ".glsl", ".h", ".inc", ".md"}.contains(
              entry.path().extension().string()))
        files.push_back(entry.path());
  return files;
}

}  // namespace

TEST_CASE("References: entries are whole, each once, by key", "[references]") {
  const std::map<std::string, std::vector<std::string>> needed = {{"article", {"journal", "year"}},
                                                                  {"inproceedings", {"booktitle", "year"}},
                                                                  {"incollection", {"booktitle", "publisher", "year"}},
                                                                  {"book", {"publisher", "year"}},
                                                                  {"phdthesis", {"school", "year"}},
                                                                  {"mastersthesis", {"school", "year"}},
                                                                  {"techreport", {"institution", "year"}},
                                                                  {"manual", {"organization", "year"}},
                                                                  {"misc", {"url"}}};
  const std::vector<Reference> all = references();
  const std::string text = contentOf(root / "src/optics/references.bib");
  CHECK(all.size() == static_cast<size_t>(std::ranges::count(text, '@')));
  CHECK(all.size() > 80);
  std::string before;
  for (const Reference& reference : all) {
    INFO(reference.key);
    std::string key = reference.key;
    std::ranges::transform(key, key.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    CHECK(before < key);
    before = key;
    REQUIRE(needed.contains(reference.type));
    std::vector<std::string> names = needed.at(reference.type);
    names.insert(names.end(), {"author", "title"});
    for (const std::string& name : names) {
      INFO(name);
      CHECK((reference.fields.contains(name) && !reference.fields.at(name).empty()));
    }
    for (const auto& [name, value] : reference.fields) {
      INFO(name << " = " << value);
      if (name == "doi") CHECK(std::regex_match(value, std::regex(R"(10\.\d{4,9}/[^\s]+)")));
      if (name == "url") CHECK(std::regex_match(value, std::regex(R"(https?://[^\s]+)")));
      if (name == "year") CHECK(std::regex_match(value, std::regex(R"((19|20)\d\d)")));
      if (name == "year") CHECK(reference.key.find(value) != std::string::npos);
    }
  }
}

TEST_CASE("References: whatever is cited has an entry, and every entry is cited", "[references]") {
  const std::vector<Reference> all = references();
  std::set<std::string> cited;
  size_t count = 0;
  for (const fs::path& file : writtenFiles()) {
    const std::string text = contentOf(file);
    for (const Citation& citation : citationsIn(text)) {
      INFO(fs::relative(file, root).string()
           << " cites " << described(citation) << ", which src/optics/references.bib lacks");
      ++count;
      bool known = false;
      for (const Reference& reference : all)
        if (cites(citation, reference)) known = true, cited.insert(reference.key);
      CHECK(known);
    }
  }
  CHECK(count > 200);
  std::set<std::string> keys, table;
  addWords(contentOf(root / "src/optics/SOURCES.md"), table);
  for (const Reference& reference : all) {
    keys.insert(reference.key);
    if (table.contains(reference.key)) cited.insert(reference.key);
  }
  for (const auto rows : {selftest::checkSources(), report::tableSources(), report::methodSources()})
    for (const optics::Sources& row : rows)
      for (const std::string& key : optics::sourcesOf(rows, row.name)) {
        INFO(row.name << " names " << key);
        CHECK(keys.contains(key));
        cited.insert(key);
      }
  for (const Reference& reference : all) {
    INFO(reference.key << " is cited nowhere");
    CHECK(cited.contains(reference.key));
  }
}

TEST_CASE("References: what a citation is", "[references]") {
  const auto names = [](const std::string& text) {
    std::string all;
    for (const Citation& citation : citationsIn(text)) all += described(citation) + (citation.others ? "+" : "") + "; ";
    return all;
  };
  CHECK(names("// Smith's Lambda, Heitz 2014 eq. 66 (Laine and\n// Karras 2011)") ==
        "Smith's Lambda Heitz 2014; Laine Karras 2011; ");
  CHECK(names("Walter et al. 2007, Lagarde and de Rousiers (2014)") == "Walter 2007+; Lagarde Rousiers 2014; ");
  CHECK(names("D(H); Heitz 2014. Rec. 2020") == "Heitz 2014; ");
  CHECK(names("(Mahy, Van Eycken, Oosterlinck 1994)") == "Mahy Van Eycken Oosterlinck 1994; ");
  CHECK(names("Filip and Vávra 2014, CIE 1931, RFC 1951, \"Fit\", 2001, a 1920 x 1080 picture") ==
        "Filip Vavra 2014; ");
  const Reference reference{"article", "Moeller1997", {{"year", "1997"}}, {{"Moller", "Tomas"}, {"Trumbore", "Ben"}}};
  CHECK(cites(citationsIn(" Moeller and Trumbore 1997").at(0), reference));
  CHECK(cites(citationsIn(" By slabs: Moeller 1997").at(0), reference));
  CHECK_FALSE(cites(citationsIn(" Trumbore 1997").at(0), reference));
  CHECK_FALSE(cites(citationsIn(" Moeller and Haines 1997").at(0), reference));
  CHECK_FALSE(cites(citationsIn(" Moeller et al. 1997").at(0), reference));
  CHECK_FALSE(cites(citationsIn(" Moeller 1998").at(0), reference));
}

TEST_CASE("References: SOURCES.md names functions, keys and DOIs that are there", "[references]") {
  const std::string text = contentOf(root / "src/optics/SOURCES.md");
  std::set<std::string> words;
  for (const fs::path& file : writtenFiles())
    if (file.extension() != ".md") addWords(contentOf(file), words);
  std::set<std::string> keys, dois;
  for (const Reference& reference : references()) {
    keys.insert(reference.key);
    if (reference.fields.contains("doi")) dois.insert(reference.fields.at("doi"));
  }
  size_t rows = 0;
  std::istringstream lines(text);
  const std::regex function("`(\\w+)`"), key("\\b[A-Z][A-Za-z]+[12]\\d{3}[A-Za-z]*\\b"),
      doi("doi\\.org/(10\\.[^ \n]*)\\)");
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| ---") || line.starts_with("| formula")) continue;
    INFO(line);
    ++rows;
    CHECK(std::ranges::count(line, '|') == 5);
    const std::string formula = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator at(formula.begin(), formula.end(), function); at != std::sregex_iterator(); ++at) {
      INFO((*at)[1]);
      CHECK(words.contains((*at)[1]));
    }
    for (std::sregex_iterator at(line.begin(), line.end(), key); at != std::sregex_iterator(); ++at) {
      INFO(at->str());
      CHECK(keys.contains(at->str()));
    }
    std::string links = std::regex_replace(line, std::regex("\\), |\\) \\|"), ")\n");
    for (std::sregex_iterator at(links.begin(), links.end(), doi); at != std::sregex_iterator(); ++at) {
      INFO((*at)[1]);
      CHECK(dois.contains((*at)[1]));
    }
  }
  CHECK(rows > 50);
}

TEST_CASE("References: every table of the reports says whose formulas it shows", "[references]") {
  std::set<std::string> tables;
  const std::regex first(R"~(Table \w+\{\s*"([\w-]+)")~"), named(R"~(\.name = "([\w-]+)",\s*\.title =)~");
  for (const char* folder : {"src/report", "src/commands"})
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder)) {
      const std::string text = contentOf(entry.path());
      for (const std::regex& pattern : {first, named})
        for (std::sregex_iterator at(text.begin(), text.end(), pattern); at != std::sregex_iterator(); ++at)
          tables.insert((*at)[1]);
    }
  CHECK(tables.size() > 25);
  for (const std::string& table : tables) {
    INFO(table << ": add a row to src/report/sources.cpp");
    CHECK(optics::namesSources(report::tableSources(), table));
  }
  for (const optics::Sources& row : report::tableSources()) {
    INFO(row.name << " is no table");
    CHECK(tables.contains(std::string(row.name)));
  }
}
