"""Locates elements of MJCF and URDF: their file, their line and their position."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from xml.parsers import expat

import mujoco

GROUPS = ("frame", "replicate")
"""Elements within a body that group other elements."""


@dataclass(frozen=True, eq=False)
class Element:
    """A tag of a file."""

    tag: str
    attributes: dict[str, str]
    file: Path
    line: int
    start: int
    """Position of its first byte in the file."""
    children: list["Element"] = field(default_factory=list)

    def walk(self) -> Iterator["Element"]:
        """Yield this element and all elements within it, in the order of the file."""
        yield self
        for child in self.children:
            yield from child.walk()

    def sections(self, tag: str) -> Iterator["Element"]:
        return (child for child in self.children if child.tag == tag)


Texts = Mapping[Path, bytes]
"""Contents that replace those of files, by path."""


def parse(path: Path, root: Path | None = None, texts: Texts | None = None) -> Element:
    """Return the root element of a file, with included files in place of their tags.

    Raises:
        OSError: The file cannot be read.
        expat.ExpatError: The file is not XML.
    """
    root = root or path.parent
    texts = texts or {}
    parser = expat.ParserCreate()
    open_elements: list[Element] = []
    roots: list[Element] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(
            tag, attributes, path, parser.CurrentLineNumber, parser.CurrentByteIndex
        )
        # Like IncludeXML in MuJoCo's xml.cc: the children of the included root element
        # replace the tag.
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

    def end(_: str) -> None:
        open_elements.pop()

    parser.EndElementHandler = end
    parser.Parse(texts[path] if path in texts else path.read_bytes(), True)
    return roots[0]


def _included(name: str, path: Path, root: Path, texts: Texts) -> list[Element]:
    # MuJoCo first looks beside the first file, then beside the one that includes.
    for folder in (root, path.parent):
        file = Path(os.path.normpath(folder / name))
        if file.is_file():
            return parse(file, root, texts).children
    return []


COUNTS = {"joint": "njnt", "actuator": "nu", "equality": "neq"}
"""Fields of the model that count its objects, unless they are called n and the kind."""
SECTIONS = {
    "actuator": "actuator",
    "equality": "equality",
    "tendon": "tendon",
    "keyframe": "key",
}
"""The kind of all elements in some sections, which does not depend on their tags."""
Placed = tuple[Element, str | None]
"""An element, and its class or its section."""


class Source:
    """The elements of a scene's file, with the objects of the model that they define."""

    def __init__(self, root: Element | None, model: mujoco.MjModel):
        self.root = root
        self._model = model
        self._placed: dict[str, dict[int, Placed]] = {}

    @classmethod
    def of(
        cls, path: Path | None, model: mujoco.MjModel, texts: Texts | None = None
    ) -> "Source":
        try:
            return cls(parse(path, texts=texts) if path else None, model)
        except (OSError, expat.ExpatError, IndexError):
            return cls(None, model)

    @cached_property
    def _in_order(self) -> list[Placed]:
        """Return the elements of all bodies and sections, in the order of the model."""
        if self.root is None or self.root.tag != "mujoco":
            return []
        worlds = self.root.sections("worldbody")
        children = [child for world in worlds for child in world.children]
        world = Element("body", {}, self.root.file, 1, 0, children)
        sections = [
            (child, section.tag)
            for section in self.root.children
            if section.tag in SECTIONS or section.tag == "asset"
            for child in section.children
        ]
        return [*_within(world, None), *sections]

    def placed(self, kind: str) -> dict[int, Placed]:
        """Return the element and the class of each geom, joint and so on.

        Elements and objects of the model are matched by order or, if the counts or the
        names differ, by name.
        """
        if kind not in self._placed:
            self._placed[kind] = self._matched(kind)
        return self._placed[kind]

    def _matched(self, kind: str) -> dict[int, Placed]:
        tags = (kind, f"free{kind}")
        placed = [
            (element, name)
            for element, name in self._in_order
            if element.tag in tags or SECTIONS.get(name or "") == kind
        ]
        count = getattr(self._model, COUNTS.get(kind, f"n{kind}"))
        names = [getattr(self._model, kind)(index).name for index in range(count)]
        authored = [element.attributes.get("name", "") for element, _ in placed]
        # replicate appends to each name.
        if len(placed) == count and all(map(str.startswith, names, authored)):
            return dict(enumerate(placed))
        named = dict(zip(authored, placed, strict=True))
        return {index: named[name] for index, name in enumerate(names) if name in named}

    @property
    def geoms(self) -> dict[int, Placed]:
        """Return the element and the class of each geom that can be located."""
        return self.placed("geom")

    @cached_property
    def _defaults(self) -> dict[str, list[Element]]:
        defaults: dict[str, list[Element]] = {}

        def visit(element: Element, outer: list[Element], name: str) -> None:
            chain = [element, *outer]
            # A class may have several <default> tags, for example in two included
            # files; later ones override earlier ones.
            defaults[name] = chain + [
                default for default in defaults.get(name, []) if default not in chain
            ]
            for child in element.sections("default"):
                visit(child, chain, child.attributes.get("class", name))

        for element in self.root.sections("default") if self.root else ():
            visit(element, [], element.attributes.get("class", "main"))
        return defaults

    def authored(self, geom: int, attribute: str) -> Element | None:
        """Return the element that sets an attribute of a geom, or None."""
        if geom not in self.geoms:
            return None
        element, name = self.geoms[geom]
        if attribute in element.attributes:
            return element
        # The first class in MJCF applies to all geoms, even if it is not called main.
        main = next(iter(self._defaults.values()), [])
        for default in self._defaults.get(name, main) if name else main:
            for child in default.sections("geom"):
                if attribute in child.attributes:
                    return child
        return None

    def option(self, attribute: str = "") -> Element | None:
        """Return the ``<option>`` that sets an attribute, or else any of them."""
        options = list(self.root.sections("option")) if self.root else []
        authoring = [
            element for element in options if attribute in element.attributes
        ] or options
        # If there are several, the last one counts in MuJoCo.
        return authoring[-1] if authoring else None

    def find(self, kind: str, index: int) -> Element | None:
        """Return the element of a body, joint, actuator, equality, tendon or so on."""
        placed = self.placed(kind)
        return placed[index][0] if index in placed else None

    def pair(self, *names: str) -> Element | None:
        """Return the ``<pair>`` that names two geoms."""
        for section in self.root.sections("contact") if self.root else ():
            for pair in section.sections("pair"):
                ends = [pair.attributes.get(name) for name in ("geom1", "geom2")]
                if {*ends} == {*names}:
                    return pair
        return None


def _within(element: Element, inherited: str | None) -> Iterator[Placed]:
    """Yield a body and its elements with their classes, then the bodies within it."""
    yield element, inherited
    children = list(_children(element, element.attributes.get("childclass", inherited)))
    for child, name in children:
        if child.tag != "body":
            yield child, child.attributes.get("class", name)
    for child, name in children:
        if child.tag == "body":
            yield from _within(child, name)


def _children(
    element: Element, childclass: str | None
) -> Iterator[tuple[Element, str | None]]:
    """Yield the children of a body with their childclass, replicated if needed."""
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
