"""The algebra, the Hamiltonian and the Casimirs of Lie-Poisson systems."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from .algebras import Algebra, Brackets, algebra_source, native_parameters
from .arguments import array, choice, real
from .events import Function, function_source
from .methods import SCHEMES, tolerance_of
from .open_terms import Element, Inputs, OpenNames, depends_on_time, native_inputs, native_open
from .realisation import Realisation, realisation
from .solution import Floats, names_of_groups

Parameters = Mapping[str, Union[float, ArrayLike]]

State = Union[ArrayLike, Mapping[str, ArrayLike]]
"""A state: the coordinates in their order, or their values by name."""


class SystemDescription:
    """A Lie algebra, and a Hamiltonian h on its dual, with what is known of them. `System` describes the arguments."""

    _first: Optional[Floats] = None
    """The start that the system was made with."""

    def __init__(
        self,
        algebra: Optional[str] = None,
        hamiltonian: Optional[Function] = None,
        *,
        parameters: Optional[Parameters] = None,
        coordinates: Union[None, str, Sequence[str]] = None,
        brackets: Optional[Brackets] = None,
        structure_constants: Optional[ArrayLike] = None,
        kind: Optional[str] = None,
        bracket: Optional[str] = None,
        representation: Optional[ArrayLike] = None,
        momenta: Optional[ArrayLike] = None,
        representations: Optional[Mapping[str, ArrayLike]] = None,
        inputs: Optional[Inputs] = None,
        drive: Optional[Element] = None,
        damping: Union[None, float, Mapping[str, Any]] = None,
        noise: Optional[Mapping[str, Any]] = None,
        torque: Optional[Element] = None,
    ) -> None:
        tables = native_inputs(inputs)
        forces = (drive, damping, noise, torque)

        def opened(names: Mapping[str, slice]) -> OpenNames:
            return OpenNames(names, self._parameters, [name for name, *_ in tables])

        self._numbers, self._parameters = native_parameters(parameters or {})
        given = Algebra(algebra, coordinates, brackets, structure_constants, representations)
        self._kind = None if kind is None else str(kind)
        if self._kind is not None:
            others = (hamiltonian, bracket, representation, momenta, *given)
            if any(part is not None for part in others):
                raise ValueError("a kind has its algebra and its Hamiltonian: write neither, or leave out kind")
            self._system = _native.System((self._kind,), None, self._numbers, False, None, None)
            self._names = names_of_groups(self._system.groups)
            if tables or any(part is not None for part in forces):
                terms = native_open(opened(self._names), tables, *forces)
                self._system = _native.System((self._kind,), None, self._numbers, False, None, terms)
        else:
            if hamiltonian is None:
                raise ValueError("hamiltonian is missing: a formula or a function of the coordinates")
            source = algebra_source(given)
            self._names = names_of_groups(_native.coordinate_groups(source, self._numbers))
            if tables or any(part is not None for part in forces) or depends_on_time(hamiltonian, self._parameters):
                names = opened(self._names)
                function, terms = names.scalar("hamiltonian", hamiltonian), native_open(names, tables, *forces)
            else:
                function, terms = function_source("hamiltonian", hamiltonian, self._names, self._parameters), None
            is_plus = choice("bracket", bracket or "minus", ("minus", "plus")) == "plus"
            own = realisation(representation, momenta)
            self._system = _native.System(source, function, self._numbers, is_plus, own, terms)
        self._algebra = algebra or self._kind or "brackets"

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return max(int(places.stop) for places in self._names.values())

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The names of the coordinates, in their order."""
        names: list[str] = [""] * self.dimension
        for name, places in self._names.items():
            if places.stop - places.start == 1:
                names[places.start] = name
        return tuple(names)

    @property
    def hamiltonian(self) -> str:
        """The Hamiltonian as text. A part of a traced function that is used several times is named first: s1 = ...; ..."""
        return self._system.hamiltonian

    @property
    def casimirs(self) -> dict[str, str]:
        """The Casimirs that were found, by the symbols that runs give them."""
        return {f"c{i + 1}": text for i, text in enumerate(self._system.casimirs)}

    @property
    def bracket(self) -> str:
        """The sign of the bracket, "minus" or "plus"."""
        return "plus" if self._system.has_plus_bracket else "minus"

    @property
    def realisation(self) -> Optional[Realisation]:
        """What the matrices obey along which the collective formulation goes; None if it goes along none."""
        verdict = self._system.verdict
        if verdict is None:
            return None
        is_plus, defect, rank, odd_powers = verdict
        return Realisation("plus" if is_plus else "minus", defect, rank, odd_powers, odd_powers < 1e-10)

    @property
    def missing_casimirs(self) -> int:
        """How many independent Casimirs were not found, since they are no polynomials of low degree."""
        return self._system.missing_casimirs

    @property
    def invariants(self) -> tuple[str, ...]:
        """The symbols of h and of the Casimirs, "c1" and so on, which a closed system conserves."""
        return ("h", *self.casimirs)

    @property
    def kept(self) -> tuple[str, ...]:
        """The symbols of those that the motion keeps. A drive, damping or noise changes h, and a torque the Casimirs of the coordinates
        on which it acts, too."""
        return tuple(symbol for symbol, is_kept in zip(self.invariants, self._system.kept) if is_kept)

    @property
    def formulations(self) -> tuple[str, ...]:
        """The formulations that the algebra has, the default one first."""
        return tuple(self._system.formulations)

    @property
    def structure_constants(self) -> Floats:
        """The structure constants c of shape (d, d, d): [e_i, e_j] = sum_k c[i, j, k] e_k."""
        constants = np.zeros((self.dimension,) * 3)
        for i, j, k, value in self._system.structure_constants:
            constants[i, j, k], constants[j, i, k] = value, -value
        return constants

    def invariant_values(self, y: ArrayLike, t: ArrayLike = 0.0) -> dict[str, Floats]:
        """Returns h and the Casimirs of states of shape (d,) or (d, n), by symbol, at one time or at n."""
        states = self._states("y", y)
        rows = states.reshape(self.dimension, -1).T
        values = self._system.invariant_values(rows, np.broadcast_to(array("t", t), len(rows)).tolist())
        return {name: values[:, i].reshape(states.shape[1:]) for i, name in enumerate(self.invariants)}

    def rate(self, y: ArrayLike, t: float = 0.0) -> Floats:
        """Returns dmu/dt at states of shape (d,) or (d, n), in the same shape; with noise the drift in Stratonovich's sense."""
        states, time = self._states("y", y), real("t", t)
        return self._system.rates(states.reshape(self.dimension, -1).T, time).T.reshape(states.shape)

    def _method(self, formulation: Any, scheme: Any, tolerance: Any) -> tuple[Optional[str], str, float]:
        if formulation is not None:
            formulation = choice("formulation", formulation, self.formulations)
        scheme = choice("scheme", self._usual_scheme() if scheme is None else scheme, SCHEMES)
        return formulation, scheme, tolerance_of(tolerance)

    def _usual_scheme(self) -> str:
        """The scheme of a run unless another one is asked for."""
        return "gauss-8"

    def _states(self, name: str, y: ArrayLike) -> Floats:
        states = array(name, y)
        if states.ndim not in (1, 2) or states.shape[0] != self.dimension:
            d = self.dimension
            raise ValueError(f"{name} must have the shape ({d},) or ({d}, n), got {states.shape}")
        return states

    def _start(self, y0: Optional[State]) -> Floats:
        """Returns the coordinates of one state, or of the start that the system was made with."""
        if y0 is not None:
            return self._state(y0)
        if self._first is None:
            raise ValueError("y0 is missing: this system was made without a start")
        return self._first

    def _state(self, y0: State) -> Floats:
        """Returns the coordinates of one state."""
        if isinstance(y0, Mapping):
            y0 = self._by_name(y0)
        state = array("y0", y0)
        if state.shape != (self.dimension,):
            many = "; heavytop.solve_many follows many states" if state.ndim == 2 else ""
            raise ValueError(f"y0 must have the shape {self._shape_of_state()}, got {state.shape}{many}")
        for name, x in zip(self.coordinates, state):
            real(f"y0 at {name}", x)
        return state

    def _shape_of_state(self) -> str:
        return f"({self.dimension},)"

    def _many_states(self, name: str, y: Any) -> Floats:
        """Returns one state of shape (d,) or n of shape (d, n), which may be given by name, too, or left out."""
        if y is None:
            return self._start(None)
        if isinstance(y, Mapping) or not isinstance(y, (list, tuple)) and np.shape(y) in self._shapes_of_state():
            return self._state(y)
        if isinstance(y, (list, tuple)) and y and all(isinstance(one, Mapping) for one in y):
            return np.stack([self._state(one) for one in y], axis=1)
        return self._states(name, y)

    def _shapes_of_state(self) -> list[tuple[int, ...]]:
        """The shapes of a state, besides (d,)."""
        return []

    def _by_name(self, values: Mapping[str, ArrayLike]) -> Floats:
        if self._kind is not None:
            given, _ = native_parameters(values)
            start = _native.start_of_kind(self._kind, self._numbers, given)
            if start is not None:
                return np.array(start)
        state = np.full(self.dimension, np.nan)
        for name, value in values.items():
            if name not in self._names:
                raise ValueError(f"y0 has no coordinate {name!r}; there are {', '.join(self._names)}")
            places = self._names[name]
            numbers = array(f"y0[{name!r}]", value).reshape(-1)
            if numbers.size != places.stop - places.start:
                raise ValueError(f"y0[{name!r}] must have {places.stop - places.start} numbers, got {numbers.size}")
            state[places] = numbers
        missing = [name for name, x in zip(self.coordinates, state) if np.isnan(x)]
        if missing:
            raise ValueError(f"y0 has no value for {', '.join(missing)}")
        return state

    def __repr__(self) -> str:
        text = self.hamiltonian
        short = text if len(text) <= 120 else f"{text[:117]}..."
        casimirs = ", ".join(self.casimirs.values()) or "none"
        return f"<System: {self._algebra}, h = {short}; Casimirs: {casimirs}>"
