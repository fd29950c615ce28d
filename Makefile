# Two commands: `make run` and `make test`. Everything they install stays in this folder
# (.venv, frontend/node_modules, .build, .data); only `make test` may ask apt for a Chromium and R.
SHELL := /bin/bash
PYTHON ?= python3
BIN := .venv/bin
PIP := $(BIN)/python -m pip --quiet --disable-pip-version-check
NPM := npm --prefix frontend --no-fund --no-audit --loglevel=error
WEB_SOURCES := $(shell find frontend/src backend/sightline/messages frontend/public docs CONVENTIONS.md frontend/index.html frontend/vite.config.ts frontend/package.vite.config.ts -type f 2>/dev/null)

.PHONY: run wheel image test test-postgresql test-browser setup check check-server check-pages lock types dev screenshots bench soak faults faults-machines full-disk hostile flakes proofs nightly sbom audit clean
.DELETE_ON_ERROR:

run: setup
	@exec $(BIN)/sightline demo

setup: .build/python .build/web
	@$(BIN)/python -m compileall -q backend

.build/tools:
	@mkdir -p .build
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || \
	  { echo "Sightline needs Python 3.11 or newer: install it, or name it, as in: make run PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || \
	  { echo "Python cannot make virtual environments: install it with: sudo apt install python3-venv" >&2; exit 1; }
	@node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)' 2>/dev/null || \
	  { echo "Sightline needs Node 20.19 or newer with npm, to build its pages: see nodejs.org." >&2; exit 1; }
	@touch $@

.build/python: requirements.lock pyproject.toml setup.py | .build/tools
	@echo "Installing the Python packages into .venv ..."
	@test -x $(BIN)/python || $(PYTHON) -m venv .venv
	@$(PIP) install --require-hashes -r requirements.lock
	@$(PIP) install --no-deps --no-build-isolation --editable .
	@touch $@

.build/node: frontend/package-lock.json frontend/package.json | .build/tools
	@echo "Installing the front end's packages into frontend/node_modules ..."
	@$(NPM) ci >/dev/null
	@touch $@

.build/web: .build/node $(WEB_SOURCES)
	@$(NPM) run --silent build
	@touch $@

.build/python-dev: requirements-dev.lock .build/python
	@echo "Installing the test tools into .venv ..."
	@$(PIP) install --require-hashes -r requirements-dev.lock
	@touch $@

# Chromium without a desktop around the page does the same work in three quarters of the time, so it comes first
# where apt has it; then any browser that is installed, Debian's, and the one that Playwright brings.
.build/chromium: .build/python-dev
	@apt_get() { if [ "$$(id -u)" = 0 ]; then apt-get "$$@"; else sudo -n apt-get "$$@"; fi; }; \
	 installed() { for name in "$$@"; do command -v $$name > $@ && return; done; return 1; }; \
	 from_debian() { grep -q '^ID=debian' /etc/os-release && apt_get update -qq && \
	   apt_get install -y -qq $$1 && installed $$1; } >/dev/null 2>&1; \
	 installed chromium-headless-shell || from_debian chromium-headless-shell || \
	 installed chromium chromium-browser google-chrome google-chrome-stable || from_debian chromium || \
	 { $(BIN)/playwright install chromium && echo playwright > $@; } || \
	 { rm -f $@; echo "The browser tests need Chromium: install it (sudo apt install chromium) and run make test again." >&2; exit 1; }

# The R example of docs/examples is run where R is; Debian has it as a package, elsewhere it is left out, and said.
.build/r: .build/tools | .build/chromium # after it: apt lets one in at a time
	@if command -v Rscript > $@; then exit 0; fi; \
	 if grep -q '^ID=debian' /etc/os-release && [ "$$(id -u)" = 0 ]; then \
	   apt-get update -qq && apt-get install -y -qq --no-install-recommends r-base-core >/dev/null; \
	 elif grep -q '^ID=debian' /etc/os-release && sudo -n true 2>/dev/null; then \
	   sudo apt-get update -qq && sudo apt-get install -y -qq --no-install-recommends r-base-core >/dev/null; \
	 fi; command -v Rscript > $@ || echo "R is not here: its example is not tested." | tee $@ >&2

# Some machines forbid it: every process would compile the code, and rewrite the tests' assertions, once more.
test test-postgresql test-browser: export PYTHONDONTWRITEBYTECODE :=
# Two workers share two cores: threads of NumPy and OpenCV beside them would wait for each other, spinning.
test test-postgresql test-browser: export OPENBLAS_NUM_THREADS := 1
test test-postgresql test-browser: export OMP_NUM_THREADS := 1
test test-postgresql test-browser: export OPENCV_FOR_THREADS_NUM := 1

# A third worker has the processor while others wait for a child, a clock or a disk.
WORKERS := 3
test:
	@$(MAKE) --no-print-directory -j2 setup .build/python-dev
	@$(MAKE) --no-print-directory -j2 -Oline .build/chromium .build/r check
	@SIGHTLINE_TEST_DATABASE_URL= $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -m "not proof" --ignore=tests/browser
	@$(MAKE) --no-print-directory test-postgresql
	@$(MAKE) --no-print-directory test-browser

# The files that name the dialect mark alone: collecting the others takes longer than these tests.
# One stage after the other: beside each other on two cores both wait for the processor.
test-postgresql:
	@if [ -n "$$SIGHTLINE_TEST_DATABASE_URL" ]; then echo "The same on PostgreSQL ..." && \
	   $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -m "dialect and not once and not proof" \
	   $$(grep -rl 'mark\.dialect' tests --include='test_*.py'); fi

# As many browsers as here; the files of each are fixed (tests/browser/conftest.py). What failed in a browser is tried
# once more and named at the end.
BROWSERS := 3
test-browser:
	@SIGHTLINE_TEST_DATABASE_URL= $(BIN)/python -m pytest -n $(BROWSERS) --dist loadgroup --no-loadscope-reorder --reruns 1 -rR -m "not proof" tests/browser

# The long runs of what make test shows on a small case: statistics, fuzz, exactness; every property by many new
# examples.
proofs: export OPENBLAS_NUM_THREADS := 1
proofs: setup .build/python-dev .build/chromium
	@SIGHTLINE_PROOFS=1 SIGHTLINE_TEST_DATABASE_URL= $(BIN)/python -m pytest -n 2 --dist worksteal -m "proof or hypothesis" --ignore=tests/browser
	@if [ -n "$$SIGHTLINE_TEST_DATABASE_URL" ]; then \
	   $(BIN)/python -m pytest -n 2 --dist worksteal -m "dialect and proof and not once" \
	   $$(grep -rl 'mark\.dialect' tests --include='test_*.py'); fi
	@SIGHTLINE_TEST_DATABASE_URL= $(BIN)/python -m pytest -n $(BROWSERS) --dist loadgroup --no-loadscope-reorder -m proof tests/browser
	@$(BIN)/python tests/bench/bench_linescan_coverage.py direct --write

check: check-server check-pages

check-server: .build/python-dev
	@$(BIN)/ruff check backend tests migrations
	@$(BIN)/ruff format --check backend tests migrations
	@$(BIN)/mypy
	@$(BIN)/lint-imports

check-pages: types
	@$(NPM) run --silent check
	@$(NPM) run --silent test

# The front end's types of what the server sends and takes, out of the server's own description. Only
# type checks and editors read them: a build strips types, so `make run` and the image need none.
types: .build/python-dev .build/node
	@$(BIN)/python -m sightline.commands.openapi .build/openapi.json
	@$(NPM) run --silent types

# Pages that reload while they are written, beside a server that runs.
dev: types
	@$(NPM) run dev

bench: setup .build/python-dev .build/chromium
	@failed=; for script in $(filter-out %bench_linescan_coverage.py,$(wildcard tests/bench/bench_*.py)); do $(BIN)/python $$script || failed="$$failed $$script"; done; \
	  [ -z "$$failed" ] || { echo "Failed:$$failed"; exit 1; }

# The pictures of the guide, in every language, from a new demonstration (or SCREENSHOTS=FOLDER, a copy of one there).
screenshots: setup .build/python-dev .build/chromium
	@$(BIN)/python -m tests.browser.guide_pictures $(SCREENSHOTS)

# Many people at once, for as long as you like: make soak SOAK="--seconds 60 --clients 1,8,32,64"
soak: setup .build/python-dev
	@$(BIN)/python -m tests.load.soak $(SOAK)

# Kills server, decoder, workers (with --postgresql the database too) under work: make faults FAULTS="--kills 100 --seed 7"
faults: setup .build/python-dev
	@$(BIN)/python -m tests.load.faults $(FAULTS)

# Two apps and two workers, PostgreSQL and S3: machines, networks, database and storage that go away, clocks apart
faults-machines: setup .build/python-dev
	@$(BIN)/python -m tests.load.machines $(FAULTS)

# A disk that fills up: make full-disk DISK=FOLDER, an empty file system of some 150 MB (mount -t tmpfs -o size=150m ...)
full-disk: setup .build/python-dev
	@$(BIN)/python -m tests.load.full_disk $(DISK)

# Spoiled files and random requests by the thousand, for the night: make hostile HOSTILE="--seed 7 --cases 1000"
hostile: setup .build/python-dev
	@$(BIN)/python -m tests.load.hostile.run $(HOSTILE)

# How often a test fails by chance, beside busy loops: make flakes N=20 [FLAKES="tests/infra/test_turns.py"];
# MINUTES=60 instead of N goes on where the last one stopped
N ?= 20
flakes: setup .build/python-dev .build/chromium
	@$(BIN)/python -m tests.load.flakes $(if $(MINUTES),--minutes $(MINUTES),$(N)) $(FLAKES)

# All of it for a night, one after the other, with one seed; the report: .build/nightly.md
nightly: setup .build/python-dev
	@$(BIN)/python -m tests.load.nightly $(NIGHTLY)

# The list of parts, CycloneDX 1.6, out of both lock files, with the licences that they state: .build/sbom.json
sbom: .build/python .build/node
	@$(BIN)/python -m tests.supply.sbom .build/sbom.json

# Known faults of what the locks hold, by pip-audit and npm; says so where the network is closed (status 2).
audit: .build/python .build/node
	@$(BIN)/python -m tests.supply.audit

# Renews the lock files. Hashes only: no lock names where a package came from.
UV := $(BIN)/uv pip compile --universal --python-version 3.11 --generate-hashes --no-emit-index-url --no-header --no-annotate --quiet
lock:
	@$(PIP) install uv
	@$(UV) --extra setup pyproject.toml -o requirements.lock
	@$(UV) --extra setup --extra dev -c requirements.lock pyproject.toml -o requirements-dev.lock
	@rm -f frontend/package-lock.json # made over an installed tree, it would list this platform's packages only
	@folder=$$(mktemp -d) && cp frontend/package.json frontend/.npmrc $$folder && \
	  npm --prefix $$folder install --package-lock-only --omit-lockfile-registry-resolved && \
	  cp $$folder/package-lock.json frontend/

# The whole app in one file: pip install dist/sightline-*.whl needs neither Node nor this folder.
wheel: setup
	@rm -rf build dist
	@$(PIP) wheel --no-deps --no-build-isolation --wheel-dir dist .
	@rm -rf build
	@ls dist/sightline-*.whl

# The images of docker-compose.yml, which hold no repository: the version is told to them.
image:
	@commit=$$(git rev-parse --short=12 HEAD) && number=$$(git describe --tags --abbrev=0 2>/dev/null | sed 's/^v//'); \
	 SIGHTLINE_VERSION="$${number:-0.1.0}+g$${commit:?}$$(git diff --quiet HEAD || echo .dirty)" docker compose build

clean:
	rm -rf .venv .build build dist frontend/node_modules frontend/dist
