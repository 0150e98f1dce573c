# What make can be asked for in every report; a Makefile says which package its editions are of (EDITION), which variables
# it has besides (OWN) and how .venv/.ready is made, and includes this. PYTHON=… takes another Python as it is.

# What is given on the command line reaches the programs through the environment, as it was typed: no make and no shell
# reads it. Variables that were exported for something else do not count.
# The Makefile's own variables are none of them, whence override.
override GIVEN := SECTION $(EDITION) WITH SINCE DEVICE CLUSTER PROFILE A B FORMAT CLAIM VALUE VALUES STRICT YES LIST \
        TARGET PORT ADDRESS PYTHON $(OWN)
override name :=
# The names of all others go along, to be refused as misspelt; not those of a make above, nor make's own.
override MAKE_KNOWN := $(GIVEN)
override MAKE_UNKNOWN := $(if $(filter 0,$(MAKELEVEL)),$(filter-out $(GIVEN) SHELL MAKEFLAGS,\
        $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))))
unexport PYTHONSAFEPATH MAKEFLAGS $(MAKE_UNKNOWN)
# Bytecode is kept: without it each of the many processes compiles all that it imports, for 2 to 4 s.
unexport PYTHONDONTWRITEBYTECODE
export MAKE_KNOWN MAKE_UNKNOWN

override define pass_on
unexport $(1)
ifeq ($$(origin $(1)),command line)
override MAKE_$(1) := $$(value $(1))
override $(1) := $$(value $(1))
export MAKE_$(1)
else
unexport MAKE_$(1)
endif
endef
$(foreach name,$(GIVEN),$(eval $(call pass_on,$(name))))

override READY :=
ifneq ($(origin MAKE_PYTHON),override)
override READY := .venv/.ready
export MAKE_PYTHON := .venv/bin/python
endif
override RUN := @"$$MAKE_PYTHON" build.py

.PHONY: report page status rerun upgrade bisect history retire check diff trace publish serve test help
.DEFAULT_GOAL := report

report: $(READY) ## Measure what is missing or stale, and build site/ [EDITION WITH DEVICE CLUSTER PROFILE ADDRESS]
	$(RUN) report

page: $(READY) ## Build site/ from what is measured; measure nothing [EDITION PROFILE ADDRESS]
	$(RUN) page

status: $(READY) ## List which sections are fresh, and what changed for the others [EDITION PROFILE]
	$(RUN) status

rerun: $(READY) ## Measure one section, and build site/ [SECTION EDITION WITH DEVICE CLUSTER PROFILE ADDRESS]
	$(RUN) rerun

upgrade: $(READY) ## Measure the deciding sections of a release, in minutes, and say what changed [EDITION WITH SINCE DEVICE PROFILE FORMAT]
	$(RUN) upgrade

bisect: $(READY) ## Find the release, commit or package that changed a claim or a value [CLAIM VALUE A B DEVICE YES]
	$(RUN) bisect

history: $(READY) ## Print a claim or a value over all editions, or the headlines [CLAIM VALUE PROFILE]
	$(RUN) history

retire: $(READY) ## Remove an edition, or, without EDITION, what searches left [EDITION WITH LIST]
	$(RUN) retire

check: $(READY) ## Print every claim with its outcome [EDITION PROFILE FORMAT STRICT]
	$(RUN) check

diff: $(READY) ## Print which claims flipped and what moved between two editions [A B PROFILE FORMAT VALUES]
	$(RUN) diff

trace: $(READY) ## Show where a number comes from: page, rows, case and command [VALUE EDITION PROFILE]
	$(RUN) trace

publish: $(READY) ## Check site/ and put it at TARGET, or on the branch gh-pages of git's origin [TARGET]
	$(RUN) publish

serve: $(READY) ## Serve site/ at http://127.0.0.1:8000, rebuilt on every change [PORT EDITION PROFILE]
	$(RUN) serve

test: $(READY) ## Run the tests; they need no GPU [EDITION]
	$(RUN) test

help: ## Print this
	@awk -F ':.*## ' '/^[a-z]+:.*## / { gsub("EDITION", "$(EDITION)"); printf "make %-9s %s\n", $$1, $$2 }' $(lastword $(MAKEFILE_LIST)) $(firstword $(MAKEFILE_LIST))
	@echo
	@echo 'SECTION=NAME            section to measure'
	@echo '$(EDITION)=1.8.0            the package that is measured, in an environment of its own: a release, a checkout, a wheel,'
	@echo '                        git+https://HOST/NAME.git@ref, or the label of what has results'
	@echo 'WITH="NAME==1.19.0"     other packages in place of those that it would come with'
	@echo 'A=1.4.0 B=1.8.0         editions to compare; 1.8.0@cpu is that of another machine'
	@echo 'DEVICE=cuda|cpu         where to measure; what takes a GPU is measured on a CPU only when asked to'
	@echo 'CLUSTER=local           all GPUs of this host; or local:2, ssh:hosts.txt, tcp://scheduler:8786'
	@echo 'PROFILE=quick           small grids and short runs, kept apart in results/quick/'
	@echo 'SINCE=1.8.0             edition to compare an upgrade with; otherwise the same one unpinned, or the one before'
	@echo 'CLAIM=SECTION.NAME      claim to follow'
	@echo 'VALUE=SECTION.NAME      value to follow, of site/data/values.json; or of a row: SECTION.CASE.COLUMN'
	@echo 'FORMAT=json|markdown    what diff and check print, for a program or a pull request'
	@echo 'VALUES=all              let diff list every value that moved'
	@echo 'YES=1                   begin what takes hours on a CPU'
	@echo 'LIST=1                  let retire only list what there is, with sizes'
	@echo 'STRICT=1                let check end with status 1 when anything cannot be trusted'
	@echo 'TARGET=dir:PATH         where to publish: also rsync:HOST:PATH and git:REMOTE'
	@echo 'PORT=8000               where to serve'
	@echo 'PYTHON=PATH             a Python that has everything already, on a host without network'
