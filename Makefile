# make help says what there is. Every target sets up .venv by itself, once; PYTHON=… takes another Python as it is.

# Its own variables: FAST=1 runs only the tests that a change of words or figures needs, in 90 s; LAB=1 is for verify.
override EDITION := NEWTON
override OWN := FAST LAB
include packages/measured-report/measured_report/skeleton/report.mk

# What every report can be asked for, by name; report.mk says what each does.
report:
page:
status:
rerun:
upgrade:
bisect:
history:
retire:
check:
diff:
trace:
publish:
serve:
test:
help:

.PHONY: clips verify worlds torture lint

clips: $(READY) ## Render the clips from kept poses, in minutes on a GPU [EDITION DEVICE PROFILE]
	$(RUN) clips

verify: $(READY) ## Measure the headline again here, and compare it with the tracked one [EDITION DEVICE LAB]
	$(RUN) verify

worlds: $(READY) ## Build and check the site as other measurements would make it
	$(RUN) worlds

torture: $(READY) ## Kill, fill and damage what there is, and write docs/reliability.md
	$(RUN) torture

lint: $(READY) ## Check style and types of the sources
	@"$$MAKE_PYTHON" -m ruff check .
	@"$$MAKE_PYTHON" -m ruff format --check .
	@"$$MAKE_PYTHON" -m mypy

.venv/.ready: pyproject.toml uv.lock
	@for python in python3 python3.12 python3.13 python3.11 python3.10; do \
		"$$python" -c 'import sys; sys.exit(not (3, 10) <= sys.version_info < (3, 14))' 2>/dev/null && \
			PYTHONPATH=packages/measured-report exec "$$python" -m measured_report.editions.environment; \
	done; \
	echo "Python 3.10, 3.11, 3.12 or 3.13 is needed, and there is $$(python3 --version 2>&1 || echo none)" >&2; \
	exit 2
