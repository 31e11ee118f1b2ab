# mayfly_test(NAME SOURCES ... USES ... [LABELS ...] [SERIAL]): one GoogleTest executable, test_NAME, and one ctest entry a case.
# SERIAL is for tests that use every core or a machine-wide resource.

include(GoogleTest)
find_package(GTest REQUIRED)

# MAYFLY_DATA goes through from the environment: tests with real data skip themselves, visibly, where it isn't set.
function(mayfly_test NAME)
  cmake_parse_arguments(ARG "SERIAL" "" "SOURCES;USES;LABELS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS OR NOT ARG_SOURCES)
    message(FATAL_ERROR "mayfly_test(${NAME}): needs SOURCES, does not know '${ARG_UNPARSED_ARGUMENTS}'")
  endif()
  add_executable(test_${NAME} ${ARG_SOURCES})
  target_include_directories(test_${NAME} PRIVATE ${CMAKE_SOURCE_DIR})
  # Where tests find the project's own files (config/, fixtures), whatever directory they run in.
  target_compile_definitions(test_${NAME} PRIVATE MAYFLY_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                                  MAYFLY_BINARY_DIR="${CMAKE_BINARY_DIR}")
  target_link_libraries(test_${NAME} PRIVATE ${ARG_USES} GTest::gtest_main GTest::gmock)
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
endfunction()

# Adds every directory below DIRECTORY that has a CMakeLists.txt: a new test room needs no line anywhere else.
function(mayfly_test_rooms DIRECTORY)
  file(GLOB lists CONFIGURE_DEPENDS LIST_DIRECTORIES false "${CMAKE_CURRENT_SOURCE_DIR}/${DIRECTORY}/*/CMakeLists.txt")
  foreach(list IN LISTS lists)
    get_filename_component(room "${list}" DIRECTORY)
    add_subdirectory("${room}")
  endforeach()
endfunction()
