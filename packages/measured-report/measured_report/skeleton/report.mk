# make NAME hands NAME to build.py, which says what there is: make help. A Makefile says how .venv/.ready is made, which
# targets are its OWN, and includes this. PYTHON=… takes another Python as it is.

# What is typed behind make reaches build.py through the environment as it was typed: no make and no shell reads it.
# First of all, since what is named here is overridden; the name of the loop's own variable would be lost in the loop.
override name :=
override TYPED := $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))
override define pass_on
unexport $(1)
override TYPED_$(1) := $$(value $(1))
override $(1) := $$(value $(1))
export TYPED_$(1)
endef
$(foreach name,$(filter-out SHELL MAKEFLAGS TYPED,$(TYPED)),$(eval $(call pass_on,$(name))))

override READY := $(if $(filter PYTHON,$(TYPED)),,.venv/.ready)
ifneq ($(READY),)
override TYPED_PYTHON := .venv/bin/python
endif
export TYPED_PYTHON
override TYPED := $(filter-out SHELL MAKEFLAGS PYTHON,$(TYPED))
export TYPED
# Bytecode is kept: without it each of the many processes compiles all that it imports, for 2 to 4 s.
unexport PYTHONSAFEPATH PYTHONDONTWRITEBYTECODE MAKEFLAGS

.DEFAULT_GOAL := report
override ASKED := $(filter-out .venv/.ready $(OWN),$(or $(MAKECMDGOALS),$(.DEFAULT_GOAL)))
.PHONY: $(ASKED)
override export GOAL = $@
$(ASKED): $(READY)
	@"$$TYPED_PYTHON" build.py "$$GOAL"
