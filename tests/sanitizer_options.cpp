// How the sanitizers behave in our tests, in the binary itself, so that it doesn't matter who starts it.

// The names are the sanitizers' own. NOLINTBEGIN(readability-identifier-naming)
extern "C" {

const char* __lsan_default_suppressions();
const char* __lsan_default_options();
const char* __asan_default_options();
const char* __ubsan_default_options();
const char* __tsan_default_suppressions();
const char* __tsan_default_options();

// PoCL, LLVM and fontconfig keep what they allocated until the process ends; Assimp forgets what it was
// reading when it refuses a damaged file.
const char* __lsan_default_suppressions() {
  return "leak:libpocl\n"
         "leak:libLLVM\n"
         "leak:libclang-cpp\n"
         "leak:libOpenCL\n"
         "leak:libhwloc\n"
         "leak:libfontconfig\n"
         "leak:libassimp\n";
}
const char* __lsan_default_options() {
  return "print_suppressions=0";
}
const char* __asan_default_options() {
  return "detect_stack_use_after_return=1:strict_string_checks=1";
}
const char* __ubsan_default_options() {
  return "print_stacktrace=1";
}

// Libraries that are not instrumented: what they do among themselves looks like races.
const char* __tsan_default_suppressions() {
  return "called_from_lib:libpocl.so\n"
         "race:libpocl\n"
         "race:libtbb\n"
         "mutex:libpocl\n";
}
const char* __tsan_default_options() {
  return "halt_on_error=1:ignore_noninstrumented_modules=1";
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
