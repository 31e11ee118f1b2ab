# Everything about how the project is compiled that is not about what it is made of.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(MAYFLY_TESTS "build the tests and examples" ON)
option(MAYFLY_BENCH "build the benchmarks" ON)
set(MAYFLY_ARCH "native" CACHE STRING "value of -march; empty for the compiler's default")
set(MAYFLY_SANITIZE "" CACHE STRING "e.g. address,undefined or thread: instruments every target, libraries included")
option(MAYFLY_COVERAGE "instrument for coverage" OFF)

find_program(MAYFLY_CCACHE ccache)
if(MAYFLY_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${MAYFLY_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${MAYFLY_CCACHE})
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # As in gcc, whose -Wconversion leaves signedness to the reader.
  add_compile_options(-Wno-sign-conversion)
else()
  # Vector types change the calling convention with -march; nothing passes them across our binary's border.
  add_compile_options(-Wno-psabi)
  # GCC 12 sees overlapping copies in "literal" + std::string (its bug 105651).
  add_compile_options(-Wno-restrict)
endif()
# The same expression must give the same bits in every engine, compiler and thread count (docs/decisions).
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math)
if(MAYFLY_ARCH)
  add_compile_options(-march=${MAYFLY_ARCH})
endif()
if(MAYFLY_SANITIZE)
  add_compile_options(-fsanitize=${MAYFLY_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # The optimiser takes twice as long over checks, and saves less time in the tests than that.
  add_compile_options(-O1 -g1)
  add_link_options(-fsanitize=${MAYFLY_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC's flow warnings misfire on instrumented code, the standard library's included; the other trees judge by them.
    add_compile_options(-Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
endif()
if(MAYFLY_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()
