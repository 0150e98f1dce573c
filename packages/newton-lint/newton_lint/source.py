"""Where a scene says what: the elements of MJCF and URDF with their file, line and place in the text."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from xml.parsers import expat

import mujoco

GROUPS = ("frame", "replicate")
"""Elements of a body that are no bodies of their own."""


@dataclass(frozen=True, eq=False)
class Element:
    """A tag as it stands in its file."""

    tag: str
    attributes: dict[str, str]
    file: Path
    line: int
    start: int
    """Byte of the file at which it opens."""
    children: list["Element"] = field(default_factory=list)

    def walk(self) -> Iterator["Element"]:
        """Yield it and all within it, in their order."""
        yield self
        for child in self.children:
            yield from child.walk()

    def sections(self, tag: str) -> Iterator["Element"]:
        return (child for child in self.children if child.tag == tag)


Texts = Mapping[Path, bytes]
"""What files are taken to hold, by their paths, in place of what they hold."""


def parse(path: Path, root: Path | None = None, texts: Texts | None = None) -> Element:
    """Return a file's first element, included ones in place of their tags; raises OSError and expat.ExpatError."""
    root = root or path.parent
    texts = texts or {}
    parser = expat.ParserCreate()
    open_elements: list[Element] = []
    roots: list[Element] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(
            tag, attributes, path, parser.CurrentLineNumber, parser.CurrentByteIndex
        )
        # As IncludeXML of MuJoCo's xml.cc: the children of its root stand where the tag stood.
        if tag == "include" and open_elements and "file" in attributes:
            open_elements[-1].children.extend(
                _included(attributes["file"], path, root, texts)
            )
        elif open_elements:
            open_elements[-1].children.append(element)
        else:
            roots.append(element)
        open_elements.append(element)

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: open_elements.pop()
    parser.Parse(texts[path] if path in texts else path.read_bytes(), True)
    return roots[0]


def _included(name: str, path: Path, root: Path, texts: Texts) -> list[Element]:
    for folder in (
        root,
        path.parent,
    ):  # MuJoCo's order: beside the first file, then beside the one that includes
        file = Path(os.path.normpath(folder / name))
        if file.is_file():
            return parse(file, root, texts).children
    return []


class Source:
    """The elements of a scene's file, and which geom of the model stands where: if none fits, those that names tell."""

    def __init__(self, root: Element | None, model: mujoco.MjModel):
        self.root = root
        self._model = model

    @classmethod
    def of(
        cls, path: Path | None, model: mujoco.MjModel, texts: Texts | None = None
    ) -> "Source":
        try:
            return cls(parse(path, texts=texts) if path else None, model)
        except (OSError, expat.ExpatError, IndexError):
            return cls(None, model)

    @cached_property
    def _placed(self) -> list[list[tuple[Element, str | None]]]:
        """Return the geoms of each body with their classes, in the order of the file."""
        if self.root is None or self.root.tag != "mujoco":
            return []
        worlds = [
            child
            for world in self.root.sections("worldbody")
            for child in world.children
        ]
        return list(
            _bodies(Element("worldbody", {}, self.root.file, 1, 0, worlds), None)
        )

    @cached_property
    def geoms(self) -> dict[int, tuple[Element, str | None]]:
        """Return element and class of the geoms whose place is known."""
        bodies = self._placed
        model = self._model
        in_order = [geom for geoms in bodies for geom in geoms]
        names = [model.geom(index).name for index in range(model.ngeom)]
        if list(map(len, bodies)) == model.body_geomnum.tolist():
            authored = [element.attributes.get("name", "") for element, _ in in_order]
            if all(
                map(str.startswith, names, authored)
            ):  # replicate appends to each name
                return dict(enumerate(in_order))
        named = {
            geom[0].attributes["name"]: geom
            for geom in in_order
            if "name" in geom[0].attributes
        }
        return {index: named[name] for index, name in enumerate(names) if name in named}

    @cached_property
    def _defaults(self) -> dict[str, list[Element]]:
        defaults: dict[str, list[Element]] = {}

        def visit(element: Element, outer: list[Element], name: str) -> None:
            chain = [element, *outer]
            # A class may stand in several <default>, as where two files are included: the last says more.
            defaults[name] = chain + [
                default for default in defaults.get(name, []) if default not in chain
            ]
            for child in element.sections("default"):
                visit(child, chain, child.attributes.get("class", name))

        for element in self.root.sections("default") if self.root else ():
            visit(element, [], element.attributes.get("class", "main"))
        return defaults

    def authored(self, geom: int, attribute: str) -> Element | None:
        """Return the element that says a geom's attribute, its own or a default's; None where none does."""
        if geom not in self.geoms:
            return None
        element, name = self.geoms[geom]
        if attribute in element.attributes:
            return element
        main = next(
            iter(self._defaults.values()), []
        )  # MJCF's first class counts for all, whatever its name
        for default in self._defaults.get(name, main) if name else main:
            for child in default.sections("geom"):
                if attribute in child.attributes:
                    return child
        return None

    def geom(self, index: int) -> Element | None:
        """Return a geom's own element."""
        return self.geoms[index][0] if index in self.geoms else None

    def option(self, attribute: str = "") -> Element | None:
        """Return the ``<option>`` that says an attribute; any where none does, and None where there is none."""
        options = (
            list(self.root.sections("option"))
            if self.root and self.root.tag == "mujoco"
            else []
        )
        authoring = [
            element for element in options if attribute in element.attributes
        ] or options
        return (
            authoring[-1] if authoring else None
        )  # of several MuJoCo's reader lets the last count

    def key(self, index: int) -> Element | None:
        """Return a ``<key>``."""
        return dict(enumerate(self._within("keyframe", "key"))).get(index)

    def pair(self, *names: str) -> Element | None:
        """Return the ``<pair>`` of two geoms, by their names."""
        pairs = self._within("contact", "pair")
        return next(
            (
                p
                for p in pairs
                if {p.attributes.get("geom1"), p.attributes.get("geom2")} == {*names}
            ),
            None,
        )

    def _within(self, section: str, tag: str) -> Iterator[Element]:
        for element in self.root.sections(section) if self.root else ():
            yield from element.sections(tag)


def _bodies(
    element: Element, inherited: str | None
) -> Iterator[list[tuple[Element, str | None]]]:
    """Yield the geoms of a body, and of those within it, with their classes."""
    children = list(_children(element, element.attributes.get("childclass", inherited)))
    yield [
        (child, child.attributes.get("class", name))
        for child, name in children
        if child.tag == "geom"
    ]
    for child, name in children:
        if child.tag == "body":
            yield from _bodies(child, name)


def _children(
    element: Element, childclass: str | None
) -> Iterator[tuple[Element, str | None]]:
    """Yield a body's children with their childclass; those of a replicate count as often as it says."""
    for child in element.children:
        if child.tag in GROUPS:
            for _ in range(
                int(child.attributes.get("count", "1"))
                if child.tag == "replicate"
                else 1
            ):
                yield from _children(
                    child, child.attributes.get("childclass", childclass)
                )
        else:
            yield child, childclass
