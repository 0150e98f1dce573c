# make NAME passes NAME to build.py; make help lists all names. A Makefile that includes this file defines how .venv/.ready
# is made, and which targets are its OWN. PYTHON=… uses another Python without changing it.

# Variables on the command line reach build.py as make quotes them (MAKEOVERRIDES), so neither make nor a shell expands
# them. Exporting them would expand them. The loop variable is cleared, because it would hide a variable of this name.
override name :=
unexport $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))
override export TYPED := $(-*-command-variables-*-)
override READY := $(if $(filter command,$(origin PYTHON)),,.venv/.ready)
override export PYTHON := $(if $(READY),.venv/bin/python,$(value PYTHON))
# Bytecode is kept. Otherwise, each of the many processes would compile its imports for 2 to 4 s.
unexport PYTHONSAFEPATH PYTHONDONTWRITEBYTECODE MAKEFLAGS

.DEFAULT_GOAL := report
override export GOALS := $(filter-out .venv/.ready $(OWN),$(or $(MAKECMDGOALS),$(.DEFAULT_GOAL)))
.PHONY: $(GOALS)
override export GOAL = $@
$(GOALS): $(READY)
	@"$$PYTHON" build.py "$$GOAL"
