# mayfly_test(NAME SOURCES ... USES ... [LABELS ...] [SERIAL] [UNSANITIZED]): one GoogleTest executable, test_NAME, and one
# ctest entry a case.
#   LABELS threads   also run under ThreadSanitizer
#   SERIAL           for tests that use every core or a machine-wide resource
#   UNSANITIZED      not run again under AddressSanitizer; say why beside it

include(GoogleTest)
find_package(GTest REQUIRED)

option(MAYFLY_SANITIZED_TESTS "ctest here also runs the tests of build/asan-ubsan and build/tsan, which must be built" OFF)

# What the sanitizers' trees are for, and nothing else: see scripts/test.
add_custom_target(sanitized_tests)
add_custom_target(thread_tests)

add_library(mayfly_sanitizer_options OBJECT EXCLUDE_FROM_ALL ${CMAKE_SOURCE_DIR}/tests/sanitizer_options.cpp)

# MAYFLY_DATA goes through from the environment: tests with real data skip themselves, visibly, where it isn't set.
function(mayfly_test NAME)
  cmake_parse_arguments(ARG "SERIAL;UNSANITIZED" "" "SOURCES;USES;LABELS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS OR NOT ARG_SOURCES)
    message(FATAL_ERROR "mayfly_test(${NAME}): needs SOURCES, does not know '${ARG_UNPARSED_ARGUMENTS}'")
  endif()
  add_executable(test_${NAME} ${ARG_SOURCES})
  set_target_properties(test_${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_include_directories(test_${NAME} PRIVATE ${CMAKE_SOURCE_DIR})
  # Where tests find the project's own files (config/, fixtures) and programs, whatever directory they run in.
  target_compile_definitions(test_${NAME} PRIVATE MAYFLY_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                                  MAYFLY_BINARY_DIR="${CMAKE_BINARY_DIR}")
  target_link_libraries(test_${NAME} PRIVATE ${ARG_USES} GTest::gtest_main GTest::gmock)
  if(MAYFLY_SANITIZE)
    target_link_libraries(test_${NAME} PRIVATE mayfly_sanitizer_options)
  endif()
  set(properties "")
  if(ARG_LABELS)
    list(JOIN ARG_LABELS "\\;" labels)
    list(APPEND properties LABELS "${labels}")
  endif()
  if(ARG_SERIAL)
    list(APPEND properties RUN_SERIAL ON)
  endif()
  # Listed when ctest starts, not when the test is linked: a build never runs what it has just built.
  gtest_discover_tests(test_${NAME} TEST_PREFIX "${NAME}." DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300 ${properties})

  if("threads" IN_LIST ARG_LABELS)
    add_dependencies(thread_tests test_${NAME})
  endif()
  if(NOT ARG_UNSANITIZED AND NOT MAYFLY_UNSANITIZED_LEVEL)
    mayfly_sanitized_test(asan-ubsan ${NAME} "${properties}" tests/test_${NAME} --gtest_brief=1)
    add_dependencies(sanitized_tests test_${NAME})
    if("threads" IN_LIST ARG_LABELS)
      mayfly_sanitized_test(tsan ${NAME} "${properties}" tests/test_${NAME} --gtest_brief=1)
    endif()
  endif()
endfunction()

# mayfly_sanitized_test(PRESET NAME PROPERTIES PROGRAM arguments ...): one ctest entry for a whole program of another tree, so
# that a single summary tells of all.
function(mayfly_sanitized_test PRESET NAME PROPERTIES PROGRAM)
  if(MAYFLY_SANITIZED_TESTS)
    add_test(NAME ${PRESET}.${NAME} COMMAND ${CMAKE_SOURCE_DIR}/build/${PRESET}/${PROGRAM} ${ARGN})
    set_tests_properties(${PRESET}.${NAME} PROPERTIES TIMEOUT 600 ${PROPERTIES} LABELS sanitizer)
  endif()
endfunction()

# Adds every directory below DIRECTORY that has a CMakeLists.txt: a new test room needs no line anywhere else.
function(mayfly_test_rooms DIRECTORY)
  file(GLOB lists CONFIGURE_DEPENDS LIST_DIRECTORIES false "${CMAKE_CURRENT_SOURCE_DIR}/${DIRECTORY}/*/CMakeLists.txt")
  foreach(list IN LISTS lists)
    get_filename_component(room "${list}" DIRECTORY)
    add_subdirectory("${room}")
  endforeach()
endfunction()
