"""The commands that only this report has, each in a module as in measured_report/commands/."""
