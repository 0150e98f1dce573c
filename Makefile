# make help says what there is. Every target sets up .venv by itself, once; PYTHON=… takes another Python as it is.

override OWN := lint
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

.PHONY: lint
lint: $(READY)
	@"$$TYPED_PYTHON" -m ruff check .
	@"$$TYPED_PYTHON" -m ruff format --check .
	@"$$TYPED_PYTHON" -m mypy

# Where there is no uv, the one of the lock is installed for the time being.
.venv/.ready: pyproject.toml uv.lock
	@uv=$$(command -v uv) || { python3 -m venv .venv.tools && .venv.tools/bin/pip install --quiet \
		"uv==$$(sed -n '/^name = "uv"$$/{n;s/^version = "\(.*\)"/\1/p;}' uv.lock)" && uv=.venv.tools/bin/uv; } && \
		"$$uv" sync --quiet --frozen && touch $@
