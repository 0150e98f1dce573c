"""Found: what the sections found, and what the story asks of them first."""

from dataclasses import replace

from measured_report.claims.claims import FAILS, HOLDS, Claim
from measured_report.deriving.findings import Findings


class Found(Findings):
    """The findings of one release."""

    @property
    def does_slip(self) -> bool:
        """Whether the cube slips as shipped."""
        return self.holds("reproduction", "slips")

    @property
    def does_hold(self) -> bool:
        """Whether stiff pads hold it better."""
        return self.holds("reproduction", "stiff_pads_hold")

    def titled(self, name: str) -> Claim:
        """Return whether the cube slips, and stiff pads hold it better."""
        slips, held = self.claim("reproduction", "slips").outcome, self.claim("reproduction", "stiff_pads_hold").outcome
        both = HOLDS if held == HOLDS else FAILS
        outcome = both if slips == HOLDS else slips
        return Claim(name, replace(outcome, reads=slips.reads | held.reads), {"slips": self.does_slip})
