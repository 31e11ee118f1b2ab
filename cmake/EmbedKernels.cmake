# Puts kernels/*.cl into the program as text: mayfly_embed_kernels(OUTPUT_VARIABLE) gives the name of a generated .cpp that
# defines compute::embedded_sources(). It is made anew when a .cl, or any header that one includes, changes.
#
# The same file is the script that does it (cmake -P), so that neither Python nor xxd is needed.

function(mayfly_embed_kernels OUTPUT_VARIABLE)
  set(folder ${CMAKE_SOURCE_DIR}/kernels)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cl)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_kernels.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DOUTPUT=${output} -DDEPFILE=${output}.d
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${sources} ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPFILE ${output}.d
    COMMENT "Embedding kernels"
    VERBATIM)
  set(${OUTPUT_VARIABLE} ${output} PARENT_SCOPE)
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  return()
endif()
cmake_minimum_required(VERSION 3.25)

# Appends FILE to `text`, each of its `#include "kernels/x.h"` replaced by that file, once. Everything else stays as it is,
# and #line keeps the compiler's messages true. compute/sources.cpp does the same at run time.
function(flatten FILE)
  if(FILE IN_LIST seen)
    return()
  endif()
  list(APPEND seen ${FILE})
  file(READ "${FOLDER}/${FILE}" rest)
  string(APPEND text "#line 1 \"kernels/${FILE}\"\n")
  set(line 1)
  string(PREPEND rest "\n")  # so that an include on the first line is found like any other
  while(TRUE)
    string(FIND "${rest}" "\n#include \"kernels/" at)
    if(at EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${rest}" 0 ${at} before)
    math(EXPR at "${at} + 1")
    string(SUBSTRING "${rest}" ${at} -1 rest)
    if(NOT before STREQUAL "")
      string(SUBSTRING "${before}" 1 -1 body)
      string(APPEND text "${body}\n")
      string(REGEX REPLACE "[^\n]+" "" newlines "${before}")
      string(LENGTH "${newlines}" count)
      math(EXPR line "${line} + ${count}")
    endif()
    string(REGEX MATCH "kernels/([^\"]+)\"" ignored "${rest}")
    set(name "${CMAKE_MATCH_1}")
    string(FIND "${rest}" "\n" end)
    string(SUBSTRING "${rest}" ${end} -1 rest)
    flatten(${name})
    math(EXPR line "${line} + 1")
    string(APPEND text "#line ${line} \"kernels/${FILE}\"\n")
  endwhile()
  string(SUBSTRING "${rest}" 1 -1 rest)
  string(APPEND text "${rest}")
  set(text "${text}" PARENT_SCOPE)
  set(seen "${seen}" PARENT_SCOPE)
endfunction()

file(GLOB sources RELATIVE ${FOLDER} ${FOLDER}/*.cl)
list(SORT sources)
set(entries "")
set(dependencies "")
foreach(source IN LISTS sources)
  set(text "")
  set(seen "")
  flatten(${source})
  string(REGEX REPLACE "\\.cl$" "" name ${source})
  string(APPEND entries "    {\"${name}\", R\"mayfly(${text})mayfly\"},\n")
  foreach(file IN LISTS seen)
    string(APPEND dependencies " ${FOLDER}/${file}")
  endforeach()
endforeach()
list(LENGTH sources count)
file(WRITE ${OUTPUT} "// Generated from kernels/*.cl by cmake/EmbedKernels.cmake.
#include <array>

#include \"compute/sources.hpp\"

namespace mayfly::compute {

std::span<const EmbeddedSource> embedded_sources() noexcept {
  static constexpr std::array<EmbeddedSource, ${count}> kSources{{
${entries}  }};
  return kSources;
}

}  // namespace mayfly::compute
")
file(WRITE ${DEPFILE} "${OUTPUT}:${dependencies}\n")
