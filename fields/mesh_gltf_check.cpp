#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "fields/mesh_file.hpp"

namespace mayfly::fields {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kGlb = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinary = 0x004E4942;  // "BIN"
constexpr std::size_t kDepth = 64;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

struct Container {
  std::string_view json;
  std::string_view binary;  // GLB only
  bool is_glb = false;
};

Result<Container> open_glb(std::string_view bytes, const std::string& name) {
  if (bytes.size() < 20 || word(bytes, 4) != 2 || word(bytes, 8) > bytes.size()) {
    return bad_mesh(
        name, "is truncated, or not glTF 2", std::to_string(bytes.size()) + " bytes",
        bytes.size() < 12 ? "a GLB header" : std::to_string(word(bytes, 8)) + " bytes, version 2");
  }
  Container container{{}, {}, true};
  for (std::size_t at = 12; at + 8 <= word(bytes, 8);) {
    const std::size_t length = word(bytes, at);
    if (length > bytes.size() - at - 8) {
      return bad_mesh(name, "is damaged", "a chunk of " + std::to_string(length) + " bytes",
                      "at most " + std::to_string(bytes.size() - at - 8));
    }
    const std::string_view chunk = bytes.substr(at + 8, length);
    if (word(bytes, at + 4) == kJson) {
      container.json = chunk;
    } else if (word(bytes, at + 4) == kBinary) {
      container.binary = chunk;
    }
    at += 8 + length;
  }
  return container;
}

bool too_deep(std::string_view json) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (quoted) {
      i += json[i] == '\\' ? 1 : 0;
      quoted = i >= json.size() || json[i] != '"' || json[i - 1] == '\\';
    } else if (json[i] == '"') {
      quoted = true;
    } else if (json[i] == '{' || json[i] == '[') {
      if (++depth > kDepth) {
        return true;
      }
    } else if ((json[i] == '}' || json[i] == ']') && depth > 0) {
      --depth;
    }
  }
  return false;
}

// A non-negative whole number, or `missing`; anything else is an error that carries the key's name.
std::uint64_t whole(const Json& object, const char* key, std::uint64_t missing) {
  const auto found = object.find(key);
  if (found == object.end()) {
    return missing;
  }
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > std::uint64_t{1} << 40) {
    throw std::invalid_argument(std::string("'") + key + "': " + found->dump().substr(0, 40));
  }
  return found->get<std::uint64_t>();
}

const Json& list(const Json& root, const char* key) {
  static const Json kNone = Json::array();
  const auto found = root.find(key);
  if (found == root.end()) {
    return kNone;
  }
  if (!found->is_array()) {
    throw std::invalid_argument(std::string("'") + key + "' that is no list");
  }
  for (const Json& item : *found) {
    if (!item.is_object()) {
      throw std::invalid_argument(std::string("an item of '") + key + "' that is no object");
    }
  }
  return *found;
}

const Json& item_of(const Json& root, const char* key, std::uint64_t index) {
  const Json& items = list(root, key);
  if (index >= items.size()) {
    throw std::invalid_argument("item " + std::to_string(index) + " of " + std::to_string(items.size()) +
                                " in '" + key + "'");
  }
  return items[index];
}

void need(bool holds, const std::string& otherwise) {
  if (!holds) {
    throw std::invalid_argument(otherwise);
  }
}

void check_buffer(const Json& buffer, const Container& container, const std::filesystem::path& folder) {
  const std::uint64_t promised = whole(buffer, "byteLength", 0);
  const auto uri = buffer.find("uri");
  std::uint64_t held = container.binary.size();
  if (uri != buffer.end()) {
    need(uri->is_string(), "a buffer's 'uri' that is no text");
    const std::string text = uri->get<std::string>();
    if (text.starts_with("data:")) {
      const std::size_t comma = text.find(',');
      need(comma != std::string::npos && text.substr(0, comma).ends_with(";base64"),
           "a data URI that is not base64");
      held = (text.size() - comma - 1) / 4 * 3;
    } else {
      need(text.find_first_of("/\\:") == std::string::npos && text.ends_with(".bin"),
           "a buffer in '" + text.substr(0, 80) + "', not a .bin file beside the mesh");
      std::error_code missing;
      held = std::filesystem::is_regular_file(folder / text, missing)
                 ? std::filesystem::file_size(folder / text, missing)
                 : 0;
      need(!missing, "no buffer file '" + text.substr(0, 80) + "'");
    }
  }
  need(promised <= held,
       "a buffer of " + std::to_string(held) + " bytes that should have " + std::to_string(promised));
}

std::uint64_t element_bytes(const Json& accessor) {
  const std::string type = accessor.value("type", "");
  const std::uint64_t parts = type == "SCALAR" ? 1
                              : type == "VEC2" ? 2
                              : type == "VEC3" ? 3
                              : type == "VEC4" ? 4
                                               : 0;
  const std::uint64_t component = whole(accessor, "componentType", 0);
  const std::uint64_t bytes = component == 5120 || component == 5121   ? 1
                              : component == 5122 || component == 5123 ? 2
                              : component == 5125 || component == 5126 ? 4
                                                                       : 0;
  need(parts * bytes > 0,
       "an accessor of type '" + type.substr(0, 40) + "', component " + std::to_string(component));
  return parts * bytes;
}

// Only those that a mesh's positions and indices use.
void check_accessor(const Json& root, std::uint64_t index) {
  const Json& accessor = item_of(root, "accessors", index);
  need(!accessor.contains("sparse") && accessor.contains("bufferView"), "a sparse or empty accessor");
  const Json& view = item_of(root, "bufferViews", whole(accessor, "bufferView", 0));
  const Json& buffer = item_of(root, "buffers", whole(view, "buffer", 0));
  const std::uint64_t element = element_bytes(accessor);
  const std::uint64_t stride = whole(view, "byteStride", element);
  const std::uint64_t count = whole(accessor, "count", 0);
  const std::uint64_t view_bytes = whole(view, "byteLength", 0);
  need(count > 0 && count < (std::uint64_t{1} << 32) && (stride == 0 || stride >= element) && stride < 4096,
       "an accessor of " + std::to_string(count) + " elements, stride " + std::to_string(stride));
  need(whole(accessor, "byteOffset", 0) + std::max(stride, element) * (count - 1) + element <= view_bytes,
       "an accessor that runs past its buffer view");
  need(whole(view, "byteOffset", 0) + view_bytes <= whole(buffer, "byteLength", 0),
       "a buffer view that runs past its buffer");
}

Json keep(const Json& from, std::initializer_list<const char*> keys) {
  Json kept = Json::object();
  for (const char* key : keys) {
    if (const auto found = from.find(key); found != from.end()) {
      kept[key] = *found;
    }
  }
  return kept;
}

Json geometry_of_primitive(const Json& root, const Json& primitive) {
  Json kept = keep(primitive, {"indices", "mode"});
  const auto attributes = primitive.find("attributes");
  need(attributes != primitive.end() && attributes->is_object() && attributes->contains("POSITION"),
       "a primitive without POSITION");
  const std::uint64_t position = whole(*attributes, "POSITION", 0);
  const Json& accessor = item_of(root, "accessors", position);
  need(accessor.value("type", "") == "VEC3" && whole(accessor, "componentType", 0) == 5126,
       "a POSITION that is not three floats");
  check_accessor(root, position);
  kept["attributes"] = {{"POSITION", position}};
  if (primitive.contains("indices")) {
    const std::uint64_t indices = whole(primitive, "indices", 0);
    need(item_of(root, "accessors", indices).value("type", "") == "SCALAR", "indices that are no scalars");
    check_accessor(root, indices);
  }
  return kept;
}

// A node with two parents, or its own ancestor, would send a walk over the nodes round for ever.
void check_node_forest(const Json& root) {
  const Json& nodes = list(root, "nodes");
  std::vector<int> parents(nodes.size(), 0);
  for (const Json& node : nodes) {
    for (const Json& child : node.value("children", Json::array())) {
      need(child.is_number_unsigned() && child.get<std::uint64_t>() < nodes.size(),
           "a child that is no node");
      need(++parents[child.get<std::size_t>()] == 1, "a node with two parents");
    }
    if (node.contains("mesh")) {
      item_of(root, "meshes", whole(node, "mesh", 0));
    }
  }
  for (const Json& scene : list(root, "scenes")) {
    for (const Json& top : scene.value("nodes", Json::array())) {
      need(top.is_number_unsigned() && top.get<std::uint64_t>() < nodes.size(),
           "a scene's node that is none");
      need(parents[top.get<std::size_t>()] == 0, "a scene's node that is another's child");
    }
  }
}

// Depth as the importer's recursion would see it.
void check_node_depth(const Json& nodes) {
  constexpr int kMaxDepth = 1000;
  std::vector<std::pair<std::size_t, int>> pending;
  std::vector<bool> is_child(nodes.size(), false);
  for (const Json& node : nodes) {
    for (const Json& child : node.value("children", Json::array())) {
      is_child[child.get<std::size_t>()] = true;
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_child[i]) {
      pending.emplace_back(i, 0);
    }
  }
  while (!pending.empty()) {
    const auto [node, depth] = pending.back();
    pending.pop_back();
    need(depth < kMaxDepth, "nodes nested deeper than " + std::to_string(kMaxDepth));
    for (const Json& child : nodes[node].value("children", Json::array())) {
      pending.emplace_back(child.get<std::size_t>(), depth + 1);
    }
  }
}

void check_extensions(const Json& root) {
  for (const Json& extension : root.value("extensionsRequired", Json::array())) {
    const std::string text = extension.is_string() ? extension.get<std::string>() : "?";
    need(text.starts_with("KHR_materials_") || text.starts_with("KHR_texture_"),
         "the required extension '" + text.substr(0, 60) + "'");
  }
}

Json geometry_of(const Json& root, const Container& container, const std::filesystem::path& folder) {
  need(root.is_object(), "JSON that is no object");
  check_extensions(root);
  for (const Json& buffer : list(root, "buffers")) {
    check_buffer(buffer, container, folder);
  }
  check_node_forest(root);
  check_node_depth(list(root, "nodes"));
  Json kept = keep(root, {"asset", "scene", "scenes", "accessors", "bufferViews", "buffers"});
  for (const Json& node : list(root, "nodes")) {
    kept["nodes"].push_back(
        keep(node, {"children", "mesh", "matrix", "translation", "rotation", "scale", "name"}));
  }
  for (const Json& mesh : list(root, "meshes")) {
    Json primitives = Json::array();
    for (const Json& primitive : list(mesh, "primitives")) {
      primitives.push_back(geometry_of_primitive(root, primitive));
    }
    kept["meshes"].push_back({{"primitives", primitives}});
  }
  need(kept.contains("meshes") && kept.contains("nodes"), "no mesh that stands in a scene");
  return kept;
}

void append_word(std::string& bytes, std::size_t value) {
  const auto narrow = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

std::string packed(const Json& root, const Container& container) {
  std::string json = root.dump();
  if (!container.is_glb) {
    return json;
  }
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string binary(container.binary);
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  std::string glb;
  append_word(glb, kGlb);
  append_word(glb, 2);
  append_word(glb, 12 + 8 + json.size() + 8 + binary.size());
  append_word(glb, json.size());
  append_word(glb, kJson);
  glb += json;
  append_word(glb, binary.size());
  append_word(glb, kBinary);
  return glb + binary;
}

}  // namespace

Result<std::string> geometry_of_gltf(std::string_view bytes, const std::string& name,
                                     const std::filesystem::path& folder) {
  Container container{bytes, {}, false};
  if (bytes.size() >= 4 && word(bytes, 0) == kGlb) {
    Result<Container> glb = open_glb(bytes, name);
    if (!glb) {
      return tl::unexpected(std::move(glb.error()));
    }
    container = *glb;
  }
  if (too_deep(container.json)) {
    return bad_mesh(name, "cannot be read", "JSON nested deeper than " + std::to_string(kDepth),
                    "a glTF 2 scene");
  }
  const Json root = Json::parse(container.json, nullptr, false);
  if (root.is_discarded()) {
    return bad_mesh(name, "is truncated, or no glTF", "JSON that ends early or is none", "a glTF 2 scene");
  }
  try {
    return packed(geometry_of(root, container, folder), container);
  } catch (const std::invalid_argument& wrong) {
    return bad_mesh(name, "cannot be used", wrong.what(), "a glTF 2 scene whose references hold");
  } catch (const Json::exception& wrong) {
    return bad_mesh(name, "cannot be used", wrong.what(), "a glTF 2 scene whose references hold");
  }
}

}  // namespace mayfly::fields
