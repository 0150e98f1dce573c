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


COUNTS = {
    "body": "nbody",
    "joint": "njnt",
    "actuator": "nu",
    "equality": "neq",
    "tendon": "ntendon",
    "key": "nkey",
    "site": "nsite",
    "hfield": "nhfield",
}
"""The field of the model that counts the elements of a kind."""
SECTIONS = {
    "actuator": "actuator",
    "equality": "equality",
    "tendon": "tendon",
    "key": "keyframe",
}
"""The section that contains the elements of a kind."""


class Source:
    """The elements of a scene's file, with the geoms of the model that they define.

    Elements and geoms are matched by order or, if the counts differ, by name.
    """

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
        """Return the geom elements and classes of each body, in the file's order."""
        if self.root is None or self.root.tag != "mujoco":
            return []
        return list(_bodies(self._world, None))

    @property
    def _world(self) -> Element:
        """Return an element with the children of all worldbody elements."""
        assert self.root is not None
        worlds = self.root.sections("worldbody")
        children = [child for world in worlds for child in world.children]
        return Element("worldbody", {}, self.root.file, 1, 0, children)

    @cached_property
    def geoms(self) -> dict[int, tuple[Element, str | None]]:
        """Return the element and the class of each geom that can be located."""
        bodies = self._placed
        model = self._model
        in_order = [geom for geoms in bodies for geom in geoms]
        names = [model.geom(index).name for index in range(model.ngeom)]
        if list(map(len, bodies)) == model.body_geomnum.tolist():
            authored = [element.attributes.get("name", "") for element, _ in in_order]
            # replicate appends to each name.
            if all(map(str.startswith, names, authored)):
                return dict(enumerate(in_order))
        named = {geom[0].attributes.get("name"): geom for geom in in_order}
        return {index: named[name] for index, name in enumerate(names) if name in named}

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
        # The first class in MJCF applies to all geoms, whatever its name is.
        main = next(iter(self._defaults.values()), [])
        for default in self._defaults.get(name, main) if name else main:
            for child in default.sections("geom"):
                if attribute in child.attributes:
                    return child
        return None

    def geom(self, index: int) -> Element | None:
        """Return the element of a geom."""
        return self.geoms[index][0] if index in self.geoms else None

    def option(self, attribute: str = "") -> Element | None:
        """Return the ``<option>`` that sets an attribute, or any if no one does."""
        options = list(self.root.sections("option")) if self.root else []
        authoring = [
            element for element in options if attribute in element.attributes
        ] or options
        # If there are several, the last one counts in MuJoCo.
        return authoring[-1] if authoring else None

    def find(self, kind: str, index: int) -> Element | None:
        """Return the element of a body, joint, actuator, equality, tendon or keyframe.

        Elements are matched by order or, if the counts differ, by name.
        """
        elements = self._elements.get(kind, [])
        if len(elements) == getattr(self._model, COUNTS[kind]):
            return elements[index]
        name = getattr(self._model, kind)(index).name
        named = {element.attributes.get("name"): element for element in elements}
        return named.get(name) if name else None

    @cached_property
    def _elements(self) -> dict[str, list[Element]]:
        """Return the elements of each kind, in the order of the model."""
        if self.root is None or self.root.tag != "mujoco":
            return {}
        elements = {
            kind: [
                child
                for section in self.root.sections(section_tag)
                for child in section.children
            ]
            for kind, section_tag in SECTIONS.items()
        }
        bodies = list(_body_elements(self._world))
        elements["body"] = bodies
        for kind in ("joint", "site"):
            elements[kind] = [
                child
                for body in bodies
                for child, _ in _children(body, None)
                if child.tag in (kind, f"free{kind}")
            ]
        elements["hfield"] = [
            child
            for assets in self.root.sections("asset")
            for child in assets.sections("hfield")
        ]
        return elements

    def pair(self, *names: str) -> Element | None:
        """Return the ``<pair>`` that names two geoms."""
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
    """Yield the geoms and classes of a body, then those of each body within it."""
    children = list(_children(element, element.attributes.get("childclass", inherited)))
    yield [
        (child, child.attributes.get("class", name))
        for child, name in children
        if child.tag == "geom"
    ]
    for child, name in children:
        if child.tag == "body":
            yield from _bodies(child, name)


def _body_elements(element: Element) -> Iterator[Element]:
    """Yield a body and all bodies within it."""
    yield element
    for child, _ in _children(element, None):
        if child.tag == "body":
            yield from _body_elements(child)


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
