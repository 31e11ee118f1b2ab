// LeakSanitizer stops the process's threads to look at their memory. Where an OpenCL runtime was opened and
// closed many times, as only this executable does, threads of PoCL's that have gone make it crash in its own
// tracer. Leaks are looked for in the suites that open a device once.

// The name is the sanitizer's own. NOLINTBEGIN(readability-identifier-naming,bugprone-reserved-identifier)
extern "C" {
int __lsan_is_turned_off();
int __lsan_is_turned_off() {
  return 1;
}
}
// NOLINTEND(readability-identifier-naming,bugprone-reserved-identifier)
