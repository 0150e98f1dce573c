# make help says what there is. Every target sets up .venv by itself, once; PYTHON=… takes another Python as it is.

ifeq ($(origin PYTHON), undefined)
PYTHON := .venv/bin/python
READY := .venv/.ready
endif

PORT ?= 8000
NEWTON_OPTION = $(if $(NEWTON),--newton '$(NEWTON)')
DEVICE_OPTION = $(if $(DEVICE),--device '$(DEVICE)')
PROFILE_OPTION = $(if $(PROFILE),--profile '$(PROFILE)')
ADDRESS_OPTION = $(if $(ADDRESS),--address '$(ADDRESS)')

.PHONY: report page status rerun check diff publish serve test lint help
.DEFAULT_GOAL := report

report: $(READY) ## Measure what is not fresh where a GPU is, and build site/ [NEWTON DEVICE PROFILE ADDRESS]
	@$(PYTHON) build.py report $(NEWTON_OPTION) $(DEVICE_OPTION) $(PROFILE_OPTION) $(ADDRESS_OPTION)

page: $(READY) ## Build site/ from what is measured, and measure nothing [NEWTON PROFILE ADDRESS]
	@$(PYTHON) build.py page $(NEWTON_OPTION) $(PROFILE_OPTION) $(ADDRESS_OPTION)

status: $(READY) ## Say which sections are fresh, and what changed for the others [NEWTON PROFILE]
	@$(PYTHON) build.py status $(NEWTON_OPTION) $(PROFILE_OPTION)

rerun: $(READY) ## Measure one section and build site/ [SECTION NEWTON DEVICE PROFILE ADDRESS]
	@$(PYTHON) build.py rerun --section '$(SECTION)' $(NEWTON_OPTION) $(DEVICE_OPTION) $(PROFILE_OPTION) $(ADDRESS_OPTION)

check: $(READY) ## Print every claim of the report with its outcome [NEWTON PROFILE]
	@$(PYTHON) build.py check $(NEWTON_OPTION) $(PROFILE_OPTION)

diff: $(READY) ## Print what moved and which claims flipped between two releases [A B PROFILE]
	@$(PYTHON) build.py diff --a '$(A)' --b '$(B)' $(PROFILE_OPTION)

publish: $(READY) ## Check site/ and put it at TARGET=dir:PATH in one step [TARGET]
	@$(PYTHON) build.py publish --target '$(TARGET)'

serve: $(READY) ## Serve site/ at http://127.0.0.1:8000 [PORT]
	@$(PYTHON) -m http.server --directory site --bind 127.0.0.1 $(PORT)

test: $(READY) ## Run the tests, which need no GPU [NEWTON]
	@$(PYTHON) build.py test $(NEWTON_OPTION)

lint: $(READY) ## Check style and types of the sources
	@$(PYTHON) -m ruff check .
	@$(PYTHON) -m ruff format --check .
	@$(PYTHON) -m mypy

help: ## Print this
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "make %-9s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)
	@echo
	@echo 'SECTION=reproduction    section to measure'
	@echo 'NEWTON=1.8.0            Newton release, measured in an environment of its own'
	@echo 'A=1.4.0 B=1.8.0         Newton releases to compare'
	@echo 'DEVICE=cuda|cpu         where to measure; a CPU only measures all when asked to'
	@echo 'PROFILE=quick           small grids and short runs, kept apart in results/quick/'
	@echo 'TARGET=dir:PATH         where to publish'
	@echo 'ADDRESS=https://…/      where the site will lie, for its feed, site map and pictures'
	@echo 'PYTHON=PATH             a Python that has everything already, on a host without network'

.venv/.ready: pyproject.toml uv.lock
	@if command -v uv >/dev/null; then \
		uv sync --frozen --quiet; \
	else \
		python3 -m venv .venv && .venv/bin/python -m pip install --quiet uv && .venv/bin/uv sync --frozen --inexact --quiet; \
	fi
	@touch $@
