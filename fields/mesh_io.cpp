#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <span>
#include <stdexcept>
#include <system_error>

#include "fields/mesh.hpp"
#include "fields/mesh_file.hpp"
#include "fields/mesh_weld.hpp"
#include "fields/polygon.hpp"

namespace mayfly::fields {

tl::unexpected<Error> bad_mesh(const std::string& name, const std::string& what, std::string found,
                               std::string wanted) {
  return fail(Error{
      Cause::kCaller, "mesh '" + name + "' " + what, std::nullopt, std::move(found), std::move(wanted), {}});
}

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kEndings{".obj", ".off", ".stl", ".ply", ".gltf", ".glb"};

Result<std::string> read_whole(const fs::path& file, const std::string& name) {
  std::error_code error;
  if (!fs::exists(file, error)) {
    return bad_mesh(name, "does not exist", file.string(), "a mesh file");
  }
  if (!fs::is_regular_file(file, error)) {
    return bad_mesh(name, "is not a file", file.string(), "a regular file");
  }
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error || bytes == 0 || bytes > kMaxMeshBytes) {
    return bad_mesh(name, bytes == 0 ? "is empty" : "is too large", std::to_string(bytes) + " bytes",
                    "1 to " + std::to_string(kMaxMeshBytes) + " bytes");
  }
  std::string content(bytes, '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in.read(content.data(), static_cast<std::streamsize>(bytes))) {
    return fail(Cause::kEnvironment,
                "mesh '" + name + "' cannot be read: no permission, or it changed meanwhile");
  }
  return content;
}

// What the importer may open: the mesh itself, from memory, and .bin buffers beside it; no materials, no
// textures.
class MeshFolder : public Assimp::IOSystem {
 public:
  MeshFolder(std::string name, std::string_view content, fs::path folder)
      : name_(std::move(name)), content_(content), folder_(std::move(folder)) {}

  bool Exists(const char* file) const override { return file == name_ || buffer(file).has_value(); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char*) override {
    if (file == name_) {
      return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(content_.data()),
                                        content_.size());
    }
    const auto content = Exists(file) ? read_whole(*buffer(file), file) : Result<std::string>{};
    if (!Exists(file) || !content) {
      return nullptr;
    }
    auto* bytes = new std::uint8_t[content->size()];  // the stream deletes it
    std::copy(content->begin(), content->end(), bytes);
    return new Assimp::MemoryIOStream(bytes, content->size(), true);
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::optional<fs::path> buffer(const std::string& file) const {
    const fs::path path = folder_ / fs::path(file).filename();
    std::error_code error;
    return path.extension() == ".bin" && fs::is_regular_file(path, error) ? std::optional(path)
                                                                          : std::nullopt;
  }

  std::string name_;
  std::string_view content_;
  fs::path folder_;
};

// The importer has a step that triangulates, but in Debian's build it aborts the program on some damaged
// files.
void append(TriangleMesh& to, glm::uint first, const aiFace& face, bool mirrored) {
  if (face.mNumIndices > kMaxCorners) {
    throw std::length_error("a face of " + std::to_string(face.mNumIndices) + " corners, more than " +
                            std::to_string(kMaxCorners));
  }
  std::vector<glm::uint> corners;
  for (const unsigned index : std::span(face.mIndices, face.mNumIndices)) {
    if (index >= to.vertices.size() - first) {
      throw std::out_of_range("a face with vertex " + std::to_string(index) + " of " +
                              std::to_string(to.vertices.size() - first));
    }
    corners.push_back(first + index);
  }
  if (mirrored) {
    std::ranges::reverse(corners);
  }
  const std::vector<glm::uvec3> triangles = triangulate(corners, to.vertices);
  to.triangles.insert(to.triangles.end(), triangles.begin(), triangles.end());
}

void append(TriangleMesh& to, const aiMesh& mesh, const aiMatrix4x4& matrix) {
  const auto first = static_cast<glm::uint>(to.vertices.size());
  for (const aiVector3D& vertex : std::span(mesh.mVertices, mesh.mNumVertices)) {
    const aiVector3D placed = matrix * vertex;
    to.vertices.emplace_back(placed.x, placed.y, placed.z);
  }
  const bool mirrored = matrix.Determinant() < 0.0F;
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    if (face.mNumIndices >= 3) {  // the rest are points and lines
      append(to, first, face, mirrored);
    }
  }
}

void append_nodes(TriangleMesh& to, const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent) {
  const aiMatrix4x4 matrix = parent * node.mTransformation;
  for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
    if (to.vertices.size() <= kMaxMeshVertices && to.triangles.size() <= kMaxMeshTriangles) {
      append(to, *scene.mMeshes[index], matrix);
    }
  }
  for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
    append_nodes(to, scene, *child, matrix);
  }
}

Result<TriangleMesh> import(const std::string& name, std::string_view content, const fs::path& folder) try {
  Assimp::Importer importer;
  importer.SetIOHandler(new MeshFolder(name, content, folder));  // the importer owns it
  const aiScene* scene = importer.ReadFile(name, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    return bad_mesh(name, "cannot be read", importer.GetErrorString(), "a mesh of triangles or polygons");
  }
  TriangleMesh mesh;
  append_nodes(mesh, *scene, *scene->mRootNode, aiMatrix4x4());
  return mesh;
} catch (const std::exception& thrown) {
  return bad_mesh(name, "cannot be read", thrown.what(), "a mesh of triangles or polygons");
}

Result<void> check_numbers(const TriangleMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) {
    return bad_mesh(name, "has no triangles", std::to_string(mesh.vertices.size()) + " vertices",
                    "at least one triangle");
  }
  if (mesh.vertices.size() > kMaxMeshVertices || mesh.triangles.size() > kMaxMeshTriangles) {
    return bad_mesh(name, "is too large", std::to_string(mesh.triangles.size()) + " triangles or more",
                    "at most " + std::to_string(kMaxMeshTriangles) + ", and " +
                        std::to_string(kMaxMeshVertices) + " vertices");
  }
  for (const glm::vec3& v : mesh.vertices) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      return bad_mesh(name, "has a vertex that is nowhere", "a coordinate that is not a finite number",
                      "finite coordinates");
    }
  }
  return {};
}

Result<std::string> checked_content(const fs::path& file, const std::string& ending,
                                    const std::string& name) {
  Result<std::string> content = read_whole(file, name);
  if (!content) {
    return content;
  }
  if (ending == ".gltf" || ending == ".glb") {
    return geometry_of_gltf(*content, name, file.parent_path());
  }
  const auto check = ending == ".off"   ? check_off
                     : ending == ".obj" ? check_obj
                     : ending == ".stl" ? check_stl
                                        : check_ply;
  if (Result<void> good = check(*content, name); !good) {
    return tl::unexpected(std::move(good.error()));
  }
  return content;
}

}  // namespace

Result<TriangleMesh> load_mesh(const fs::path& file) try {
  const std::string name = file.filename().string();
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::find(kEndings, ending) == kEndings.end()) {
    return bad_mesh(name, "has an ending that is not read", ending.empty() ? "none" : "'" + ending + "'",
                    ".obj, .off, .stl, .ply, .gltf or .glb");
  }
  const Result<std::string> content = checked_content(file, ending, name);
  if (!content) {
    return tl::unexpected(content.error());
  }
  Result<TriangleMesh> mesh = import("mesh" + ending, *content, file.parent_path());
  if (!mesh) {
    mesh.error().message = "mesh '" + name + "' cannot be read";
    return mesh;
  }
  if (Result<void> good = check_numbers(*mesh, name); !good) {
    return tl::unexpected(std::move(good.error()));
  }
  weld(*mesh);
  if (mesh->triangles.empty()) {
    return bad_mesh(name, "has no triangles", "only triangles without extent",
                    "at least one with three corners apart");
  }
  return mesh;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for mesh '" + file.filename().string() + "'");
}

}  // namespace mayfly::fields
