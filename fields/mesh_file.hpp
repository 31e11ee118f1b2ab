// Mesh files, looked at before the importer sees them: importers are lenient with truncated files, and trust
// them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace mayfly::fields {

// Each takes the file's bytes and its name (for the error) and refuses what is cut short or points outside
// itself.
Result<void> check_off(std::string_view bytes, const std::string& name);
Result<void> check_obj(std::string_view bytes, const std::string& name);
Result<void> check_stl(std::string_view bytes, const std::string& name);
Result<void> check_ply(std::string_view bytes, const std::string& name);

// glTF and GLB, in one: the same file with nothing in it but positions, indices and nodes, every reference
// checked, as far as the importer needs it. `folder` is where its buffers may lie.
Result<std::string> geometry_of_gltf(std::string_view bytes, const std::string& name,
                                     const std::filesystem::path& folder);

// "mesh 'x.off' <what>; found <found>; wanted <wanted>"
tl::unexpected<Error> bad_mesh(const std::string& name, const std::string& what, std::string found,
                               std::string wanted);

}  // namespace mayfly::fields
