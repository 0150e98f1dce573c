# make help says what there is beside lint, docs and mutate. Every target sets up .venv by itself, once; PYTHON=… takes another Python as it is.

override OWN := lint docs mutate
include packages/measured-report/measured_report/skeleton/report.mk

# Named for programs that read this file; any other command in measured_report/commands/ or report/commands/ will do.
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

# The documents, with the reference, as a site of their own beside what is published.
.PHONY: docs
docs: $(READY)
	@trap 'rm -f docs/REFERENCE.md' EXIT && "$$PYTHON" build.py reference && mv REFERENCE.md docs && \
		"$$PYTHON" -m mkdocs build --strict --quiet --site-dir published/docs

# Which errors in MODULE=values/format would the tests of its room miss? In a copy, as each is written into the file.
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
		cr-report --surviving-only --show-diff mutants && cr-rate --fail-over 5 mutants # what is left out counts as killed

# Where there is no uv, the one of the lock is installed for the time being: of that version and those bytes.
.venv/.ready: pyproject.toml uv.lock
	@uv=$$(command -v uv) || { python3 -m venv .venv.tools && awk '/^name = "uv"$$/ { on = 1 } /^$$/ { on = 0 } \
			on && /^version = / { gsub(/version = |"/, ""); printf "uv==%s", $$0 } \
			on && match($$0, /sha256:[0-9a-f]+/) { printf " --hash=%s", substr($$0, RSTART, RLENGTH) }' uv.lock \
		>.venv.tools/uv.txt && .venv.tools/bin/pip install --quiet --require-hashes --no-deps --only-binary :all: \
			--requirement .venv.tools/uv.txt && uv=.venv.tools/bin/uv; } && \
		"$$uv" sync --quiet --frozen && touch $@
