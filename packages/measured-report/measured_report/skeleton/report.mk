# make NAME hands NAME to build.py, which says what there is: make help. A Makefile says how .venv/.ready is made, which
# targets are its OWN, and includes this. PYTHON=… takes another Python as it is.

# What is typed behind make reaches build.py as make itself quotes it (MAKEOVERRIDES): nothing in it is read by make, as
# it would be to export it, nor by a shell. A variable called as the loop's would hide there.
override name :=
unexport $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))
override export TYPED := $(-*-command-variables-*-)
override READY := $(if $(filter command,$(origin PYTHON)),,.venv/.ready)
override export PYTHON := $(if $(READY),.venv/bin/python,$(value PYTHON))
# Bytecode is kept: without it each of the many processes compiles all that it imports, for 2 to 4 s.
unexport PYTHONSAFEPATH PYTHONDONTWRITEBYTECODE MAKEFLAGS

.DEFAULT_GOAL := report
override ASKED := $(filter-out .venv/.ready $(OWN),$(or $(MAKECMDGOALS),$(.DEFAULT_GOAL)))
.PHONY: $(ASKED)
override export GOAL = $@
$(ASKED): $(READY)
	@"$$PYTHON" build.py "$$GOAL"
