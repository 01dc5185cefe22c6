# python/sinew/__init__.pyi: the types of the module sinew, for editors and checkers.
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple, Union

import numpy
import numpy.typing

__version__: str
__all__: list[str]

_Path = Union[str, bytes, os.PathLike[str], os.PathLike[bytes]]
_Numbers = Union[Sequence[float], numpy.typing.NDArray[Any]]
_Floats = numpy.typing.NDArray[numpy.float32]
_Integers = numpy.typing.NDArray[numpy.int32]
_Anchor = tuple[str, _Numbers]
_Vector = tuple[float, float, float]
_Pair = tuple[float, float]
_Weights = Literal["refitted", "transferred"]
_Progress = Callable[[float], object]

class Error(ValueError):
    file: str
    place: str
    reason: str
    def __init__(self, reason: str, place: str = "", file: str = "") -> None: ...

class Bone(NamedTuple):
    number: int
    name: str
    path: str
    parent: int

class Mesh:
    @property
    def positions(self) -> _Floats: ...
    @property
    def normals(self) -> _Floats: ...
    @property
    def triangles(self) -> _Integers: ...
    @property
    def uv(self) -> _Floats: ...
    @property
    def uv_triangles(self) -> _Integers: ...
    @property
    def materials(self) -> _Integers: ...
    @property
    def influence_begin(self) -> _Integers: ...
    @property
    def influence_bones(self) -> _Integers: ...
    @property
    def influence_weights(self) -> _Floats: ...

class Character:
    def __init__(self, path: _Path) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def path(self) -> str: ...
    @property
    def height(self) -> float: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def bones(self) -> tuple[Bone, ...]: ...
    @property
    def names(self) -> tuple[str, ...]: ...
    @property
    def clips(self) -> dict[str, float]: ...
    @property
    def shapes(self) -> tuple[str, ...]: ...
    @property
    def ignored(self) -> list[str]: ...
    def add_clips(self, path: _Path) -> list[str]: ...
    def nodes(self) -> tuple[int, ...]: ...
    def duration(self, clip: str) -> float: ...
    def sample(self, clip: str | None = None, time: float = 0.0) -> _Floats: ...
    def rest(self) -> _Floats: ...
    def turned(self, turns: dict[str, _Numbers], clip: str | None = None, time: float = 0.0) -> _Floats: ...
    def from_locals(
        self,
        rotations: dict[str, _Numbers] | None = None,
        translations: dict[str, _Numbers] | None = None,
        scales: dict[str, _Numbers] | None = None,
        *,
        clip: str | None = None,
        time: float = 0.0,
    ) -> _Floats: ...
    def facts(self) -> dict[str, Any]: ...

class _Part:
    @property
    def rig(self) -> Rig: ...
    @property
    def mirror(self) -> str | None: ...
    name: str

class Muscle(_Part):
    bone: str
    group: str
    line: str | None
    # What is read is a tuple; any numbers may be set.
    center: _Vector | _Numbers
    radii: _Vector | _Numbers
    rotation: tuple[float, float, float, float] | _Numbers
    core: float
    belly: float
    bend: _Pair | _Numbers
    reach: float
    amount: float
    sign: int
    territory: tuple[str, ...] | Sequence[str] | None

class Line(_Part):
    origin: _Anchor
    insertion: _Anchor
    via: _Anchor | None
    rest: float
    tendons: _Pair | _Numbers
    volume: float
    limits: _Pair | _Numbers
    pivot: float
    twist: float
    flex: _Pair | _Numbers
    base: float
    gain: float
    full: float

class _Shapes(Mapping[str, float]):
    def __getitem__(self, name: str) -> float: ...
    def __setitem__(self, name: str, weight: float) -> None: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...

class Rig:
    def __init__(self, character: Character, *, path: _Path | None = None, text: str | None = None) -> None: ...
    mode: str
    iso: float
    skin_blend: float
    grooves: float
    detail: str
    depth: int
    tolerance: float
    patch: str
    projection: str
    crease_angle: float
    @property
    def character(self) -> Character: ...
    @property
    def path(self) -> str: ...
    @property
    def muscles(self) -> tuple[Muscle, ...]: ...
    @property
    def leaders(self) -> tuple[Muscle, ...]: ...
    @property
    def lines(self) -> tuple[Line, ...]: ...
    @property
    def groups(self) -> tuple[str, ...]: ...
    @property
    def links(self) -> tuple[tuple[str, str], ...]: ...
    @property
    def shapes(self) -> _Shapes: ...
    @property
    def unattached(self) -> list[str]: ...
    @property
    def clip_files(self) -> tuple[str, ...]: ...
    @property
    def missing_clips(self) -> list[str]: ...
    def add_clips(self, path: _Path) -> list[str]: ...
    def muscle(self, name: str) -> Muscle: ...
    def line(self, name: str) -> Line: ...
    def add_muscle(
        self,
        name: str,
        *,
        bone: str,
        center: _Numbers = (0.0, 0.0, 0.0),
        radii: _Numbers = (1.0, 1.0, 1.0),
        rotation: _Numbers = (0.0, 0.0, 0.0, 1.0),
        group: str | None = None,
        line: str | None = None,
        reach: float | None = None,
        amount: float | None = None,
        sign: int | None = None,
        core: float | None = None,
        belly: float | None = None,
        bend: _Numbers | None = None,
        territory: Sequence[str] | None = None,
    ) -> Muscle: ...
    def add_line(
        self,
        name: str,
        *,
        origin: _Anchor,
        insertion: _Anchor,
        via: _Anchor | None = None,
        rest: float | None = None,
        tendons: _Numbers | None = None,
        volume: float | None = None,
        limits: _Numbers | None = None,
        pivot: float | None = None,
        twist: float | None = None,
        flex: _Numbers | None = None,
        base: float | None = None,
        gain: float | None = None,
        full: float | None = None,
    ) -> Line: ...
    def mirror(self, muscle: str | Muscle) -> Muscle: ...
    def remove(self, muscle: str | Muscle) -> None: ...
    def link(self, group: str, other: str, amount: float = 1.0) -> None: ...
    def link_amount(self, group: str, other: str) -> float: ...
    def unlink(self, group: str, other: str) -> None: ...
    def rename_group(self, group: str, name: str) -> None: ...
    def remove_group(self, group: str) -> None: ...
    def save(self, path: _Path) -> None: ...
    def to_json(self) -> str: ...
    def copy(self) -> Rig: ...
    def __getitem__(self, name: str) -> Muscle: ...
    def __contains__(self, name: object) -> bool: ...
    def __iter__(self) -> Iterator[Muscle]: ...
    def __len__(self) -> int: ...

class Surface:
    @property
    def positions(self) -> _Floats: ...
    @property
    def normals(self) -> _Floats: ...
    @property
    def triangles(self) -> _Integers: ...
    @property
    def uv(self) -> _Floats: ...
    @property
    def uv_triangles(self) -> numpy.typing.NDArray[numpy.uint32]: ...
    @property
    def uv_vertices(self) -> _Integers: ...
    @property
    def colors(self) -> _Floats: ...
    @property
    def split_positions(self) -> _Floats: ...
    @property
    def split_normals(self) -> _Floats: ...
    @property
    def displacement(self) -> _Floats: ...
    @property
    def control_triangles(self) -> _Integers: ...
    @property
    def materials(self) -> _Integers: ...
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def clip(self) -> str | None: ...
    @property
    def time(self) -> float: ...
    def save(self, path: _Path) -> None: ...

class Smoother:
    def __init__(self, character: Character, rig: Rig | None = None, *, leave_out_missing: bool = False) -> None: ...
    @property
    def character(self) -> Character: ...
    def prepare(self, rig: Rig, *, leave_out_missing: bool = False) -> None: ...
    def __call__(
        self,
        clip: str | None = None,
        time: float = 0.0,
        *,
        bones: numpy.typing.ArrayLike | None = None,
        shapes: dict[str, float] | None = None,
        flex: float = 0.0,
        flexed: Sequence[str] | None = None,
        threads: int = 0,
    ) -> Surface: ...
    def frames(self, clip: str, fps: float = 30.0, threads: int = 0) -> Iterator[Surface]: ...

def load(path: _Path) -> Character: ...
def load_rig(path: _Path, character: Character | None = None) -> Rig: ...
def export(
    rig: Rig,
    path: _Path,
    *,
    helpers: int | None = None,
    mesh: Literal["refined", "original"] = "refined",
    weights: _Weights = "refitted",
    joint_scale: Literal["full", "uniform", "none"] = "full",
    clips: Sequence[str] | None = None,
    shapes: bool = True,
    progress: _Progress | None = None,
    threads: int = 0,
) -> dict[str, Any]: ...
def export_baked(
    rig: Rig,
    path: _Path,
    clip: str,
    *,
    fps: float = 30.0,
    substeps: int = 1,
    bound: float = 0.1,
    weights: _Weights = "refitted",
    progress: _Progress | None = None,
    threads: int = 0,
) -> dict[str, Any]: ...
