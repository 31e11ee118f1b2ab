#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "fields/mesh_file.hpp"

namespace mayfly::fields {
namespace {

struct Type {
  std::string_view name, alias;
  std::size_t bytes;
};
constexpr std::array<Type, 8> kTypes{{{"char", "int8", 1},
                                      {"uchar", "uint8", 1},
                                      {"short", "int16", 2},
                                      {"ushort", "uint16", 2},
                                      {"int", "int32", 4},
                                      {"uint", "uint32", 4},
                                      {"float", "float32", 4},
                                      {"double", "float64", 8}}};

struct Property {
  std::size_t count_bytes = 0;  // of a list's length; 0: not a list
  std::size_t bytes = 0;        // of a value
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};
enum class Format { kUnknown, kText, kLittle, kBig };
struct Header {
  Format format = Format::kUnknown;
  std::vector<Element> elements;
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlanks = " \t\r";
  for (std::size_t i = line.find_first_not_of(kBlanks); i != std::string_view::npos;
       i = line.find_first_not_of(kBlanks, i)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, i), line.size());
    words.push_back(line.substr(i, end - i));
    i = end;
  }
  return words;
}

std::string_view take_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return line;
}

std::size_t bytes_of(std::string_view type) {
  for (const Type& known : kTypes) {
    if (type == known.name || type == known.alias) {
      return known.bytes;
    }
  }
  return 0;
}

bool add_property(Header& header, const std::vector<std::string_view>& words) {
  if (header.elements.empty() || words.size() < 3) {
    return false;
  }
  const bool list = words[1] == "list";
  if (list && words.size() < 5) {
    return false;
  }
  const Property property{list ? bytes_of(words[2]) : 0, bytes_of(words[list ? 3 : 1])};
  header.elements.back().properties.push_back(property);
  return property.bytes > 0 && (!list || property.count_bytes > 0);
}

bool add_line(Header& header, const std::vector<std::string_view>& words) {
  if (words[0] == "format" && words.size() > 1) {
    header.format = words[1] == "ascii"                  ? Format::kText
                    : words[1] == "binary_little_endian" ? Format::kLittle
                    : words[1] == "binary_big_endian"    ? Format::kBig
                                                         : Format::kUnknown;
    return header.format != Format::kUnknown;
  }
  if (words[0] == "element") {
    Element element;
    if (words.size() < 3 ||
        std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count).ec !=
            std::errc{}) {
      return false;
    }
    element.name = words[1];
    header.elements.push_back(element);
    return true;
  }
  return words[0] == "property" ? add_property(header, words)
                                : words[0] == "comment" || words[0] == "obj_info" || words[0] == "ply";
}

// Takes the header off `rest`.
Result<Header> read_header(std::string_view& rest, const std::string& name) {
  Header header;
  if (!rest.starts_with("ply")) {
    return bad_mesh(name, "is not what its ending says", "no 'ply' at its start", "a PLY header");
  }
  while (!rest.empty()) {
    const auto words = words_of(take_line(rest));
    if (!words.empty() && words[0] == "end_header") {
      return header;
    }
    if (!words.empty() && !add_line(header, words)) {
      return bad_mesh(name, "has a header that cannot be read",
                      "'" + std::string(words[0].substr(0, 40)) + " …'",
                      "format, element and property lines");
    }
  }
  return bad_mesh(name, "is truncated", "the end of the file within the header", "'end_header'");
}

std::uint64_t list_length(std::string_view at, std::size_t bytes, Format format) {
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t place = format == Format::kLittle ? bytes - 1 - i : i;
    length = (length << 8) | static_cast<std::uint8_t>(at[place]);
  }
  return length;
}

// Takes one binary element off `rest`; false if it is longer than that.
bool take_binary(std::string_view& rest, const Element& element, Format format) {
  for (const Property& property : element.properties) {
    std::uint64_t values = 1;
    if (property.count_bytes > 0) {
      if (rest.size() < property.count_bytes) {
        return false;
      }
      values = list_length(rest, property.count_bytes, format);
      rest.remove_prefix(property.count_bytes);
    }
    if (values > rest.size() / property.bytes) {
      return false;
    }
    rest.remove_prefix(values * property.bytes);
  }
  return true;
}

// One line an element; a list says how many values follow.
bool take_text(std::string_view& rest, const Element& element) {
  std::vector<std::string_view> words;
  while (words.empty() && !rest.empty()) {
    words = words_of(take_line(rest));
  }
  std::size_t needed = 0;
  for (const Property& property : element.properties) {
    std::uint64_t length = 0;
    if (property.count_bytes > 0 && needed < words.size()) {
      std::from_chars(words[needed].data(), words[needed].data() + words[needed].size(), length);
    }
    needed += 1 + static_cast<std::size_t>(std::min<std::uint64_t>(length, words.size()));
  }
  return !words.empty() && words.size() >= needed;
}

}  // namespace

Result<void> check_ply(std::string_view bytes, const std::string& name) {
  std::string_view rest = bytes;
  const Result<Header> header = read_header(rest, name);
  if (!header) {
    return tl::unexpected(header.error());
  }
  for (const Element& element : header->elements) {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      const bool whole = header->format == Format::kText ? take_text(rest, element)
                                                         : take_binary(rest, element, header->format);
      if (!whole) {
        const std::string count = std::to_string(element.count);
        return bad_mesh(name, "is damaged or truncated",
                        std::to_string(i) + " of " + count + " '" + element.name + "' elements", count);
      }
    }
  }
  return {};
}

}  // namespace mayfly::fields
