# `make help` lists the commands; besides these there are `make lint`, `make docs` and `make mutate`. The first target that
# you make sets up .venv. PYTHON=… uses another Python, and installs nothing there.

override OWN := lint docs mutate
include packages/measured-report/measured_report/skeleton/report.mk

# These targets are listed for programs that read this file. Make accepts every other command in measured_report/commands/
# and report/commands/ as well.
report:
test:
status:
rerun:
check:
serve:
publish:
help:
page:
verify:
trace:
clips:
upgrade:
bisect:
history:
diff:
replicate:
carry:

.PHONY: lint
lint: $(READY)
	@"$$PYTHON" -m ruff check .
	@"$$PYTHON" -m ruff format --check .
	@"$$PYTHON" -m mypy
	@"$$PYTHON" tests/prose/check.py

# Writes docs/REFERENCE.md from the code, and builds the documents as a site beside the published report.
.PHONY: docs
docs: $(READY)
	@"$$PYTHON" build.py reference && mv REFERENCE.md docs && \
		"$$PYTHON" -m mkdocs build --strict --quiet --site-dir published/docs

# Lists the errors in MODULE=values/format that the tests of its folder would miss. It works in a copy of the project, because
# each error is written into the file.
.PHONY: mutate
mutate: override export MODULE := $(or $(value MODULE),values/format)
mutate: $(READY)
	@"$$PYTHON" -m uv sync --quiet --frozen --inexact --group mutation && PATH="$$PWD/.venv/bin:$$PATH" && \
		kept=$$(git stash create) && root=$$PWD && tree=$$(mktemp -d) && \
		trap 'git -C "$$root" worktree remove --force "$$tree"' EXIT && \
		git worktree add --quiet --detach "$$tree" "$${kept:-HEAD}" && cd "$$tree" && \
		sed "s|MODULE|$$MODULE|; s|ROOM|$${MODULE%/*}|" tests/mutation.toml > mutation.toml && \
		cosmic-ray baseline mutation.toml && cosmic-ray init mutation.toml mutants && \
		cr-filter-operators mutants mutation.toml && cosmic-ray exec mutation.toml mutants && \
		cr-report --surviving-only --show-diff mutants && cr-rate --fail-over 5 mutants # mutants that were filtered out count as detected

# If uv is not installed, this installs the version that the lock file names, and checks its digest.
.venv/.ready: pyproject.toml uv.lock
	@uv=$$(command -v uv) || { python3 -m venv .venv.tools && awk '/^name = "uv"$$/ { on = 1 } /^$$/ { on = 0 } \
			on && /^version = / { gsub(/version = |"/, ""); printf "uv==%s", $$0 } \
			on && match($$0, /sha256:[0-9a-f]+/) { printf " --hash=%s", substr($$0, RSTART, RLENGTH) }' uv.lock \
		>.venv.tools/uv.txt && .venv.tools/bin/pip install --quiet --require-hashes --no-deps --only-binary :all: \
			--requirement .venv.tools/uv.txt && uv=.venv.tools/bin/uv; } && \
		"$$uv" sync --quiet --frozen && touch $@
