from collections.abc import Sequence
from typing import Optional

import numpy as np
from numpy.typing import NDArray

MethodNames = tuple[str, str, float]
Setting = tuple[Sequence[float], float, MethodNames]
Surface = tuple[Sequence[float], float, int]

class IntegrationError(RuntimeError): ...

class Top:
    inertia: list[float]
    weight_moment: float
    center_of_mass: list[float]
    invariants: list[str]
    def __reduce__(self) -> tuple[object, ...]: ...
    def __new__(
        cls,
        inertia: Sequence[float],
        mass: float,
        gravity: float,
        length: float,
        center_of_mass: Sequence[float],
    ) -> Top: ...
    @staticmethod
    def free_rigid_body(inertia: Sequence[float]) -> Top: ...
    @staticmethod
    def lagrange(transverse: float, axial: float, weight_moment: float) -> Top: ...
    @staticmethod
    def kovalevskaya(axial: float, weight_moment: float) -> Top: ...
    @staticmethod
    def goryachev_chaplygin(axial: float, weight_moment: float) -> Top: ...
    def invariant_values(self, states: NDArray[np.float64]) -> NDArray[np.float64]: ...
    def follow(
        self,
        setting: Setting,
        end: float,
        every: int,
        attitude: bool,
    ) -> tuple[
        NDArray[np.float64],
        NDArray[np.float64],
        NDArray[np.float64],
        NDArray[np.float64],
        int,
        Optional[IntegrationError],
    ]: ...
    def states_at(
        self,
        setting: Setting,
        times: Sequence[float],
    ) -> NDArray[np.float64]: ...
    def crossings(
        self,
        setting: Setting,
        end: float,
        surface: Surface,
        most: int,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

def advance_states(
    top: Top, states: NDArray[np.float64], step: float, end: float, scheme: str
) -> tuple[NDArray[np.float64], list[tuple[int, str]]]: ...
def advance_tops(
    tops: Sequence[Top], states: NDArray[np.float64], step: float, end: float, scheme: str
) -> tuple[NDArray[np.float64], list[tuple[int, str]]]: ...
