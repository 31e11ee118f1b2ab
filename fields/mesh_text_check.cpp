#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "fields/mesh.hpp"
#include "fields/mesh_file.hpp"

namespace mayfly::fields {
namespace {

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// Lines that are neither empty nor comments, as words; "a \" at a line's end joins the next.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  const std::vector<std::string_view>& words() const { return words_; }
  std::string where() const { return " in line " + std::to_string(number_); }

  bool next() {
    words_.clear();
    while (words_.empty() && at_ < text_.size()) {
      bool joined = true;
      while (joined && at_ < text_.size()) {
        joined = add_line();
      }
    }
    return !words_.empty();
  }

 private:
  bool add_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++number_;
    line = line.substr(0, line.find('#'));
    while (!line.empty() && blank(line.back())) {
      line.remove_suffix(1);
    }
    const bool joined = !line.empty() && line.back() == '\\';
    if (joined) {
      line.remove_suffix(1);
    }
    for (std::size_t i = 0; i < line.size();) {
      if (blank(line[i])) {
        ++i;
        continue;
      }
      const std::size_t from = i;
      while (i < line.size() && !blank(line[i])) {
        ++i;
      }
      words_.push_back(line.substr(from, i - from));
    }
    return joined;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::vector<std::string_view> words_;
};

template <class T>
std::optional<T> number(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size() ? std::optional<T>(value) : std::nullopt;
}

bool three_coordinates(const std::vector<std::string_view>& words, std::size_t first) {
  for (std::size_t i = first; i < first + 3; ++i) {
    const auto value = i < words.size() ? number<double>(words[i]) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      return false;
    }
  }
  return true;
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) {
    text += (text.empty() ? "" : " ") + std::string(word.substr(0, 40));
  }
  return "'" + text.substr(0, 80) + "'";
}

bool off_face(const std::vector<std::string_view>& words, std::uint64_t vertices) {
  const auto corners = number<std::uint64_t>(words[0]);
  if (!corners || *corners < 3 || words.size() <= *corners) {
    return false;
  }
  for (std::size_t i = 1; i <= *corners; ++i) {
    const auto index = number<std::uint64_t>(words[i]);
    if (!index || *index >= vertices) {
      return false;
    }
  }
  return true;
}

// "f 3/1/2 …" and "f -1 …" (counted from the end).
bool obj_corner(std::string_view word, std::int64_t vertices, std::int64_t& highest) {
  const auto index = number<std::int64_t>(word.substr(0, word.find('/')));
  if (!index || *index == 0 || *index < -vertices) {
    return false;
  }
  highest = std::max(highest, *index);
  return true;
}

Result<void> check_ascii_stl(std::string_view bytes, const std::string& name) {
  Lines lines(bytes);
  std::size_t corners = 0;
  bool open = false;
  bool ended = false;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "solid") {
      ended = false;
    } else if (words[0] == "facet") {
      open = true;
      corners = 0;
    } else if (words[0] == "vertex") {
      ++corners;
      if (!three_coordinates(words, 1)) {
        return bad_mesh(name, "is damaged or truncated", joined(words) + lines.where(),
                        "'vertex' and three finite numbers");
      }
    } else if (words[0] == "endfacet") {
      if (!open || corners != 3) {
        return bad_mesh(name, "is damaged",
                        std::to_string(corners) + " corners before the 'endfacet'" + lines.where(), "3");
      }
      open = false;
    } else if (words[0] == "endsolid") {
      ended = true;
    }
  }
  if (!ended || open) {
    return bad_mesh(name, "is truncated, or no STL", "the end of the file", "'endsolid'");
  }
  return {};
}

// `count` lines of one kind, each of which must be good.
Result<void> off_lines(Lines& lines, std::uint64_t count, const char* kind, const auto& good,
                       const std::string& wanted, const std::string& name) {
  const std::string all = std::to_string(count) + kind;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!lines.next()) {
      return bad_mesh(name, "is truncated", std::to_string(i) + " of " + all, all);
    }
    if (!good(lines.words())) {
      return bad_mesh(name, "is damaged or truncated", joined(lines.words()) + lines.where(), wanted);
    }
  }
  return {};
}

}  // namespace

Result<void> check_off(std::string_view bytes, const std::string& name) {
  Lines lines(bytes);
  if (!lines.next() || !lines.words()[0].ends_with("OFF") || lines.words()[0].size() > 6) {
    return bad_mesh(name, "is not what its ending says",
                    lines.words().empty() ? "nothing" : joined(lines.words()), "'OFF' and counts, as text");
  }
  std::vector<std::string_view> counts(lines.words().begin() + 1, lines.words().end());
  if (counts.empty() && lines.next()) {
    counts = lines.words();
  }
  const auto vertices = counts.empty() ? std::nullopt : number<std::uint64_t>(counts[0]);
  const auto faces = counts.size() < 2 ? std::nullopt : number<std::uint64_t>(counts[1]);
  if (!vertices || !faces) {
    return bad_mesh(name, "has no counts", joined(counts) + lines.where(),
                    "the numbers of vertices and faces");
  }
  if (*vertices > kMaxMeshVertices || *faces > kMaxMeshTriangles) {
    return bad_mesh(name, "is too large, or damaged", joined(counts) + lines.where(),
                    "at most " + std::to_string(kMaxMeshVertices) + " vertices and " +
                        std::to_string(kMaxMeshTriangles) + " faces");
  }
  const auto vertex = [](const auto& words) { return three_coordinates(words, 0); };
  const auto face = [&](const auto& words) { return off_face(words, *vertices); };
  const std::string of_face =
      "a count of corners (3 or more) and as many indices of the " + std::to_string(*vertices) + " vertices";
  if (auto checked = off_lines(lines, *vertices, " vertices", vertex, "three finite coordinates", name);
      !checked) {
    return checked;
  }
  return off_lines(lines, *faces, " faces", face, of_face, name);
}

Result<void> check_obj(std::string_view bytes, const std::string& name) {
  Lines lines(bytes);
  std::int64_t vertices = 0;
  std::int64_t highest = 0;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "v") {
      ++vertices;
      if (!three_coordinates(words, 1)) {
        return bad_mesh(name, "is damaged or truncated", joined(words) + lines.where(),
                        "'v' and three finite coordinates");
      }
    } else if (words[0] == "f") {
      bool good = words.size() >= 4;
      for (std::size_t i = 1; i < words.size(); ++i) {
        good = good && obj_corner(words[i], vertices, highest);
      }
      if (!good) {
        return bad_mesh(name, "is damaged or truncated", joined(words) + lines.where(),
                        "'f' and three or more indices of vertices");
      }
    }
  }
  if (highest > vertices) {
    return bad_mesh(name, "is damaged or truncated", "a face with vertex " + std::to_string(highest),
                    "at most " + std::to_string(vertices) + ", the number of vertices");
  }
  if (highest == 0 && bytes.find("\nf ") == std::string_view::npos) {
    return bad_mesh(name, "has no triangles", std::to_string(vertices) + " vertices and no face",
                    "'v' and 'f' lines");
  }
  return {};
}

Result<void> check_stl(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kHeader = 84;
  constexpr std::size_t kFacet = 50;
  std::uint32_t facets = 0;
  if (bytes.size() >= kHeader) {
    std::memcpy(&facets, bytes.data() + kHeader - sizeof facets, sizeof facets);
  }
  const std::size_t promised = kHeader + kFacet * static_cast<std::size_t>(facets);
  if (bytes.size() >= kHeader && bytes.size() == promised) {
    return {};
  }
  if (bytes.starts_with("solid")) {
    return check_ascii_stl(bytes, name);
  }
  if (bytes.size() < promised || bytes.size() < kHeader) {
    return bad_mesh(name, "is truncated, or no STL", std::to_string(bytes.size()) + " bytes",
                    std::to_string(std::max(promised, kHeader)) + " bytes for the " + std::to_string(facets) +
                        " triangles that its header counts");
  }
  return {};
}

}  // namespace mayfly::fields
