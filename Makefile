# Two commands for a fresh Debian 12, and short names for the rest. The work is in CMakePresets.json and scripts/.
.PHONY: help demo test lint format clean

help:
	@echo 'make demo     install what is missing, build, fly the two-blocks scenario, leave a recording and a picture in out/'
	@echo 'make test     install what is missing, build, run every test (sanitizers and linters included)'
	@echo 'make lint     clang-format and clang-tidy only, on what changed'
	@echo 'make format   let clang-format rewrite the sources'
	@echo 'make clean    delete build/ and out/'

demo:
	@scripts/install-packages build
	@scripts/fetch-meshes || echo 'going on without: the demo itself needs none of them'
	@scripts/build release mayfly
	@scripts/demo

test:
	@scripts/install-packages build test
	@scripts/fetch-meshes || echo 'going on without: the tests that need them say so and are skipped'
	@scripts/test

lint:
	@scripts/install-packages build test
	@scripts/build release
	@ctest --preset release --label-regex lint --parallel "$$(nproc)"

format:
	@scripts/sources cpp hpp h cl | xargs clang-format -i

clean:
	rm -rf build out
