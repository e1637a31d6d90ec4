from collections.abc import Callable, Sequence
from typing import Optional, Union

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
MethodNames = tuple[Optional[str], str, float]
Setting = tuple[Sequence[float], float, MethodNames]
Source = Union[str, Sequence[tuple[str, float, int, int, int]]]
Event = tuple[Source, int, int]
Damping = tuple[float, Optional[bool], Optional[Sequence[float]]]
Noise = tuple[
    Union[tuple[float], tuple[float, Optional[Sequence[float]]], Sequence[Sequence[Source]]],
    Path,
    bool,
]
Open = tuple[
    Sequence[tuple[str, Sequence[float], Sequence[float], str]],
    Optional[Sequence[Source]],
    Optional[Damping],
    Optional[Noise],
    Optional[Sequence[Source]],
]
Path = tuple[int, int, Optional[float], Optional[float]]
Field = tuple[Sequence[tuple[str, Sequence[float], Sequence[float], str]], Sequence[Source]]
Lattice = tuple[Optional[tuple[float, bool]], Optional[tuple[float, Path]], Optional[Field]]
Shells = list[tuple[tuple[int, int], float]]
Fluid = tuple[tuple[float, int, float], list[list[float]], Optional[tuple[Shells, Shells, Path]]]
Callback = tuple[Callable[[Floats, float], float], int, int]
Accuracy = tuple[float, Optional[float], Optional[str]]

class IntegrationError(RuntimeError): ...

class Recorded:
    times: Floats
    states: Floats
    values: Floats
    attitudes: Floats
    events: list[tuple[Floats, Floats]]
    iterations: int
    ended_by: Optional[int]
    failure: Optional[IntegrationError]

class Indicators:
    times: list[float]
    exponents: list[list[float]]
    megno: list[list[float]]
    sali: list[list[float]]
    ends: list[list[float]]
    failures: list[tuple[int, str]]

Inertia = Union[Sequence[float], Sequence[Sequence[float]]]

class Top:
    inertia: list[float]
    principal_axes: list[list[float]]
    weight_moment: float
    center_of_mass: list[float]
    invariants: list[str]
    def __reduce__(self) -> tuple[object, ...]: ...
    def __new__(
        cls,
        inertia: Inertia,
        mass: float,
        gravity: float,
        length: float,
        center_of_mass: Sequence[float],
        is_central: bool,
    ) -> Top: ...
    @staticmethod
    def impossibility(
        inertia: Inertia, mass: float, gravity: float, length: float, center_of_mass: Sequence[float]
    ) -> Optional[str]: ...
    @staticmethod
    def free_rigid_body(inertia: Sequence[float]) -> Top: ...
    @staticmethod
    def lagrange(transverse: float, axial: float, weight_moment: float) -> Top: ...
    @staticmethod
    def kovalevskaya(axial: float, weight_moment: float) -> Top: ...
    @staticmethod
    def goryachev_chaplygin(axial: float, weight_moment: float) -> Top: ...
    def fastest_rates(self, states: Floats) -> list[float]: ...
    def invariants_from(self, states: Floats) -> list[str]: ...
    def invariant_values(self, states: Floats) -> Floats: ...
    def quantity(self, name: str, states: Floats, attitudes: Floats) -> Floats: ...
    def report(
        self, setting: Setting, end: float
    ) -> tuple[
        str,
        list[tuple[str, Optional[float], str, list[tuple[str, float]]]],
        list[tuple[list[float], float, float, float, bool, float]],
        str,
    ]: ...
    def follow(
        self,
        setting: Setting,
        end: float,
        every: int,
        attitude: tuple[bool, Optional[Sequence[float]]],
        events: Sequence[Event],
    ) -> Recorded: ...
    def accuracy(self, setting: Setting, steps: int) -> Accuracy: ...
    def check(self, setting: Setting, steps: int) -> tuple[float, Optional[float]]: ...
    def states_at(self, setting: Setting, times: Sequence[float]) -> Floats: ...

AlgebraSource = Union[
    str,
    tuple[str],
    tuple[str, list[str]],
    tuple[str, list[str], list[tuple[str, list[list[list[float]]]]]],
    tuple[list[str], list[tuple[str, str]]],
    tuple[Union[str, list[str]], list[tuple[int, int, int, float]], int],
]
Parameter = tuple[str, list[float], bool]

def coordinate_groups(
    algebra: AlgebraSource, parameters: Sequence[Parameter]
) -> list[tuple[str, int]]: ...

def start_of_kind(
    name: str, parameters: Sequence[Parameter], given: Sequence[Parameter]
) -> Optional[list[float]]: ...

class System:
    hamiltonian: str
    casimirs: list[str]
    missing_casimirs: int
    structure_constants: list[tuple[int, int, int, float]]
    formulations: list[str]
    groups: list[tuple[str, int]]
    has_plus_bracket: bool
    verdict: Optional[tuple[bool, float, int, float]]
    def __reduce__(self) -> tuple[object, ...]: ...
    def __new__(
        cls,
        algebra: AlgebraSource,
        hamiltonian: Optional[Source],
        parameters: Sequence[Parameter],
        has_plus_bracket: bool,
        realisation: Optional[tuple[list[list[list[float]]], bool]],
        open: Optional[Open],
    ) -> System: ...
    kept: list[bool]
    is_open: bool
    def on_path(self, path: int) -> System: ...
    def invariant_values(self, states: Floats, times: Optional[Sequence[float]] = None) -> Floats: ...
    def rates(self, states: Floats, time: float = 0.0) -> Floats: ...
    def fastest_rates(self, states: Floats) -> list[float]: ...
    def follow(
        self, setting: Setting, end: float, every: int, events: Sequence[Event]
    ) -> Recorded: ...
    def warning_of_end(self, start: Sequence[float], end: Sequence[float]) -> Optional[str]: ...
    def accuracy(self, setting: Setting, steps: int) -> Accuracy: ...
    def check(self, setting: Setting, steps: int) -> tuple[float, Optional[float]]: ...
    def balances(self, setting: Setting, steps: int) -> list[tuple[float, float, float]]: ...
    def require_inputs(self) -> None: ...
    def states_at(self, setting: Setting, times: Sequence[float]) -> Floats: ...

class Arrays:
    arrays: list[tuple[str, list[int]]]
    invariants: list[str]
    hamiltonian: Optional[str]
    formulations: list[str]
    def __reduce__(self) -> tuple[object, ...]: ...
    def __new__(
        cls, kind: str, parameters: Sequence[Parameter], open: Union[None, Lattice, Fluid]
    ) -> Arrays: ...
    def on_path(self, path: int) -> Arrays: ...
    def start(self, given: Sequence[Parameter]) -> Floats: ...
    kept: list[bool]
    is_open: bool
    has_noise: bool
    def invariant_values(self, states: Floats, times: Optional[Sequence[float]] = None) -> Floats: ...
    def on_grid(self, states: Floats, rows: int) -> Floats: ...
    def rates(self, states: Floats, time: float = 0.0) -> Floats: ...
    def fastest_rates(self, states: Floats) -> list[float]: ...
    def follow(
        self, setting: Setting, end: float, every: int, events: Sequence[Callback]
    ) -> Recorded: ...
    def accuracy(self, setting: Setting, steps: int) -> Accuracy: ...
    def check(self, setting: Setting, steps: int) -> tuple[float, Optional[float]]: ...
    def states_at(self, setting: Setting, times: Sequence[float]) -> Floats: ...

def advance_system(
    system: Union[System, Arrays], states: Floats, step: float, end: float, method: MethodNames
) -> tuple[Floats, list[tuple[int, str]]]: ...
def statistics_of_paths(
    system: Union[System, Arrays],
    setting: Setting,
    extent: tuple[float, int, int],
    quantiles: Sequence[float],
) -> tuple[list[float], Floats]: ...
def growth_of_system(
    system: Union[System, Arrays],
    states: Floats,
    times: tuple[float, float, int],
    method: MethodNames,
    exponents: Optional[int],
) -> Indicators: ...
def advance_states(
    top: Top, states: Floats, step: float, end: float, scheme: str
) -> tuple[Floats, list[tuple[int, str]]]: ...
def advance_tops(
    tops: Sequence[Top], states: Floats, step: float, end: float, scheme: str
) -> tuple[Floats, list[tuple[int, str]]]: ...
def invariants_of_tops(
    tops: Sequence[Top], starts: Floats, states: Floats
) -> tuple[list[str], Floats]: ...
def section_starts(
    top: Top, level: tuple[float, float], surface: tuple[str, float, int], count: int, seed: int
) -> Floats: ...
def growth_of_tops(
    tops: Sequence[Top],
    states: Floats,
    times: tuple[float, float, int],
    method: MethodNames,
    exponents: Optional[int],
) -> Indicators: ...
