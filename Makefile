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

.venv/.ready: pyproject.toml uv.lock
	@for python in python3 python3.12 python3.13 python3.11 python3.10; do \
		"$$python" -c 'import sys; sys.exit(not (3, 10) <= sys.version_info < (3, 14))' 2>/dev/null && \
			PYTHONPATH=packages/measured-report exec "$$python" -m measured_report.editions.environment; \
	done; \
	echo "Python 3.10, 3.11, 3.12 or 3.13 is needed, and there is $$(python3 --version 2>&1 || echo none)" >&2; \
	exit 2
