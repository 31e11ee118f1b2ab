// What else the table of keys is turned into. The results are kept in the repository, for editors and
// readers; a test holds them to the table.
#pragma once

#include <string>

namespace mayfly {

// JSON Schema 2020-12, for config/scenario.schema.json. Only single keys: what needs two of them is checked
// by the loader.
std::string scenario_json_schema();

// Markdown, for docs/reference/scenario.md.
std::string scenario_reference_page();

}  // namespace mayfly
