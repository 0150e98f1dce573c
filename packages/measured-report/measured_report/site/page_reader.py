"""Reader of a built site's pages."""

from html.parser import HTMLParser


class PageReader(HTMLParser):
    """Read the HTML of a page, as far as it is checked."""

    def __init__(self, html: str):
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.claims: list[dict[str, str]] = []
        self.numbers: list[dict[str, str]] = []
        self.words = ""
        """Text of the page, with the place in ``numbers``, as ``{12}``, where one is written."""
        self.policy = ""
        self._open: list[str] = []
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        attributes = {name: value or "" for name, value in attrs}
        self._open.append(tag)
        self.ids += [attributes["id"]] if "id" in attributes else []
        self.links += [attributes[name] for name in ("href", "src", "poster") if name in attributes]
        if attributes.get("http-equiv") == "Content-Security-Policy":
            self.policy = attributes["content"]
        if "data-claim" in attributes:
            self.claims.append(attributes)
        if tag == "data":
            self.words += f"{{{len(self.numbers)}}}"
            self.numbers.append({**attributes, "text": "", "in": "code" if "code" in self._open else ""})

    def handle_data(self, data):
        if self._open[-1:] == ["data"]:
            self.numbers[-1]["text"] += data
        else:
            self.words += data.replace("\xa0", " ")

    def handle_endtag(self, tag):
        while self._open and self._open.pop() != tag:
            pass
