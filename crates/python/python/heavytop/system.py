"""Lie-Poisson systems, whose Hamiltonian is a formula or a Python function."""

from __future__ import annotations

import math
import warnings
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._native import IntegrationError
from .accuracy import warn_of_accuracy
from .arguments import array, choice, course, flag, real
from .arguments import count as whole
from .events import Events, Function, NativeEvent, native_events, surface_source
from .solution import NEVER, Crossings, Floats, Run, Solution, crossings, rows_of, solution, solution_at
from .system_description import State, SystemDescription


class System(SystemDescription):
    """A Lie-Poisson system: a Lie algebra, and a Hamiltonian h on its dual.

    The equations are those of the minus bracket, dmu/dt = ad*_xi mu with xi = dh(mu), as for a top. In coordinates
    dmu_j/dt = sum_ik c_ijk xi_i mu_k, where [e_i, e_j] = sum_k c_ijk e_k; with the plus bracket the rate is the negative. The
    polynomial Casimirs of low degree are found from the brackets alone; those of so(n), so(p,q), su(n), sl(n,R), gl(n) and
    sp(2n,R) of higher degree are "tr X^k", "tr J X^k" and "Pf X" of the matrix X with tr(X xi) = <mu, xi>, and those of
    se(n) and so(p,q) |x Rn are "|Gamma ∧ L^k|^2", squares of wedge products, and "Gamma ∧ L^m" for n = 2m + 1. That of
    sl(n,R) |x Rn is "det(Gamma, Gamma X, ...)", of the rows Gamma X^j.

    Args:
        algebra: an expression of up to 256 dimensions. The coordinates are, for "so(3)", Pi; "su(2)" and "su(n)", mu;
            "sl(2)", alpha, beta and gamma; "se(2)", Pi (one) and Gamma (two); "se(3)", Pi and Gamma; "se(3)+R3", Pi, P and
            Gamma; "so(n)" and "so(p,q)", L12, L13, ...; "sl(n,R)" and "gl(n)", M11, ...; "sp(2n,R)", Q11, R11, P11, ...;
            "heisenberg(n)", q, p, z; "galilei", "bargmann" and "poincare(1,n)", J, K, P, H; "R3", p. Sums are "a + b", powers
            "so(3)^64" with Pi_1, Pi_2, ..., and semidirect products "so(3) |x R3" or "so(3) |x (R3 + R3)" with vectors Gamma.
            A vector `Pi` has the components `Pi1`, `Pi2` and `Pi3`.
        hamiltonian: also one of the time, `lambda x, t: ...` or a formula with `t` in it. A formula, such as "0.5*(Pi1^2/I1 + Pi2^2/I2) + m*g*l*c·Gamma"; or a Python function of the
            coordinates, such as `lambda x: 0.5 * x.Pi @ (x.Pi / x.I) + x.Gamma3`. A function is called once, with symbols
            instead of numbers, and computed in Rust from then on. Vectors are NumPy arrays; use the functions of NumPy or of
            `heavytop.functions`.
        parameters: numbers and vectors in the formula by name. A function has them as `x.I`, too.
        coordinates: the names of the coordinates of an algebra of your own, in their order; with structure constants also
            the name of one vector, whose components they are; with an algebra by expression other symbols than its own,
            such as ["S"] for "so(3)^64".
        brackets: the brackets of the algebra that are not zero, such as `{("K", "H"): "P"}` for [K, H] = P. They are sums of
            multiples of coordinates, such as "2*x - a*y" with a parameter a.
        structure_constants: instead of brackets, the array c of shape (d, d, d) with [e_i, e_j] = sum_k c[i, j, k] e_k.
        kind: instead of algebra and Hamiltonian, the name of a system of the library, such as "body-with-rotors"; its
            parameters go in `parameters`. Each has a class, too: `Vortices`, `SpinChain`, `Gyrostat` and others.
        bracket: "minus" or "plus".
        representation: matrices of shape (d, n, n), real or complex, of a representation of the algebra. The collective
            formulation then goes along the momenta J_a = p.rho_a q, and is the default.
        representations: matrices of shape (d, n, n), by name, of representations that the expression of the algebra names, as in
            "so(3) |x V" or "so(3) |x (V^2 + W)"; V has the coordinates V1, V2, ...
        momenta: instead of a representation, symmetric matrices S of shape (d, 2m, 2m) of the momenta J_a = z.S_a z/2, z = (q, p). Either
            sign of the matrices will do; `realisation` tells what they obey.
        inputs: numbers u(t) by tables, by name, each as (times, values, interpolation) with "constant", "linear" or "cubic" between
            the times. Formulas name them, and functions of (x, t) have them as `x.u`. A run is refused if no formula names one of them.
        drive: a control u, an element of the algebra, so that dmu/dt = ad*_(dh + u) mu: a number for each coordinate, as a
            function of (x, t), as formulas, or as formulas by the names of coordinates. It keeps the Casimirs.
        damping: the friction theta of a double bracket, which lowers h and keeps the Casimirs; or a mapping with "friction" and
            "inner_product", a number for a multiple of the unit matrix, a diagonal, or a matrix, which algebras with several vectors need. On
            so(3) and sums of it, spins, also a mapping with "friction" and "form": "gilbert", with the friction alpha in ds/dt = s x Omega +
            (alpha/|s|) s x ds/dt for the minus bracket, or "landau-lifshitz", one theta for all spins.
        noise: noise that keeps the Casimirs, in the sense of Stratonovich: a mapping with "temperature", the energy kT, which goes with damping;
            or "strength" and, as for damping, "inner_product"; or "fields", a list of elements as `drive`, each with a Brownian motion of its own.
            Besides "seed" (1), "path" (0), "rule", "together" (weak order 1) or "alternating" (weak order 2), "interval", the length of the
            intervals that determine a path (the step; runs with other steps see the same path if it is given), and "bound", that
            of the increments in standard deviations (6).
        torque: a rate F of the coordinates, dmu/dt = ad*_dh mu + F, as `drive`. It changes the Casimirs, and the system has the formulation
            "direct" alone. None acts on the directions Gamma of satellites, gyrostats and tops on a base.

    Raises:
        ValueError: if the formula is none, with the place in its text; if the brackets break the Jacobi identity; if there
            are more than 256 coordinates; or if names clash.
        TypeError: if a function branches on the state, or returns no scalar.

    Example:
        The heavy top by a formula, and by a function:

        >>> I = [2.0, 2.0, 1.0]
        >>> top = System("se(3)", "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + Gamma1", parameters={"I": I})
        >>> top.casimirs
        {'c1': 'Pi·Gamma', 'c2': '|Gamma|^2'}
        >>> same = System("se(3)", lambda x: 0.5 * x.Pi @ (x.Pi / I) + x.Gamma1)
        >>> run = same.solve({"Pi": [2, 3, 4], "Gamma": [0.6, 0, 0.8]}, step=0.1, end=100, scheme="gauss-12")
        >>> run.deviation("c1") < 1e-12, run.deviation("h") < 1e-10
        (True, True)

        A body with two rotors, by its name:

        >>> body = System(kind="body-with-rotors", parameters={"I": [1, 2, 3], "J": [0.1, 0.2]})
        >>> body.casimirs
        {'c1': 'l1', 'c2': 'l2', 'c3': '|Pi|^2'}

        A chain of three spins, with the plus bracket, ds/dt = s x B for h = -B.s:

        >>> chain = System("so(3)^3", "-sum(S[i]·S[i+1]) - S3[3]", coordinates=["S"], bracket="plus")
        >>> chain.rate([1, 0, 0, 0, 1, 0, 0, 1, 0])[-3:].round(1).tolist()
        [1.0, 0.0, 0.0]

        A body on so(4) along two vectors of R^4, by the matrices of the rotations of its planes:

        >>> import numpy as np
        >>> planes = [(i, j) for i in range(4) for j in range(i + 1, 4)]
        >>> def rotation(i, j):
        ...     rho = np.zeros((4, 4))
        ...     rho[j, i], rho[i, j] = 1, -1
        ...     return np.kron(np.eye(2), rho)
        >>> matrices = [rotation(i, j) for i, j in planes]
        >>> body = System("so(4)", "L12^2/2 + L13^2/3 + L34^2", representation=matrices)
        >>> body.realisation.bracket, body.realisation.rank, body.realisation.descends
        ('plus', 6, True)

        A rotor on the line, by its brackets:

        >>> rotor = System(
        ...     coordinates=["K", "H", "P"], brackets={("K", "H"): "P", ("K", "P"): "H"}, hamiltonian="K^2/2 + H^2 + P^2/2"
        ... )
        >>> rotor.casimirs
        {'c1': 'H^2 - P^2'}
    """

    def solve(
        self,
        y0: Optional[State] = None,
        t: Optional[ArrayLike] = None,
        *,
        step: Optional[float] = None,
        end: Optional[float] = None,
        scheme: Optional[str] = None,
        formulation: Optional[str] = None,
        tolerance: float = 0.0,
        every: int = 1,
        events: Events = None,
        path: Optional[int] = None,
        estimate: bool = True,
    ) -> Solution:
        """Follows the system from t = 0, in equal steps. An end before 0 is reached backward in time.

        Args:
            y0: the state at t = 0: the coordinates in their order, or their values by name, such as
                `{"Pi": [2, 3, 4], "Gamma": [0.6, 0, 0.8]}`. It may be left out where the system was made with a start, such
                as `Vortices(strengths, positions)`.
            t: the times of the samples, instead of an end: they begin at 0 or later and do not decrease, or begin at 0 or
                earlier and do not increase. Without `step` they must be equally spaced from 0, and their distance is the
                step.
            step: the time step.
            end: the end: a multiple of the step, to within 1e-9 of itself. If it is negative, so is the step, which may be
                written with its sign or without.
            scheme: "implicit-midpoint", "gauss-4" ... "gauss-16", "explicit-midpoint", "rk4", or one of the compositions
                "strang", "yoshida-4", "suzuki-4", "yoshida-6", "kahan-li-6" and "kahan-li-8". Without it "gauss-8", or
                "implicit-midpoint" for a lattice or a fluid with friction, forces or noise, which has no other one.
            formulation: so(3), su(2), se(3) and sums of so(3) and su(2) have "collective", by a Poisson map from a
                canonical space, which is their default, and "reduced", the same steps without a lift. With the implicit
                schemes and the compositions both conserve every Casimir to round-off. Every algebra has "direct", which
                keeps quadratic Casimirs with the implicit schemes. so(n), so(p,q), sp(2n,R) and gl(n) of dimension 4 to 64
                have "collective" along copies of their matrices, their default. Others without a centre, or with a derivation
                or a cocycle that does not vanish there, have it by a Clebsch map, which keeps Casimirs to the order of the
                scheme, or to round-off where the representation allows it. With noise, "reduced" is on so(3), su(2) and se(3),
                without a torque, with the scheme "implicit-midpoint".
            tolerance: of the stage equations of implicit schemes, relative to the state, at most 1e-3; 0 iterates to
                round-off. With noise, "reduced" keeps the Casimirs for every tolerance: 1e-6 makes its steps faster.
            every: keep each n-th sample; the last one is always kept.
            events: functions of the state whose zeros are found; as for `Top.solve`. With noise they are of the time alone, as
                surfaces of `section` are.
            path: of a system with noise, the number of the path: another number is another run with the same statistics. Without
                it, the path that `noise` has.
            estimate: whether to estimate the error of the run. The estimate repeats the run, or the beginning of a long one,
                with half the step, which takes three times as long as a short run itself. Without it the angle of a step at
                the start is judged alone.

        Returns:
            The samples. If a step fails, or an invariant or an event has no finite value at a later state than the start,
            those until then, with `success` false. If an event ends the run, the last sample is the state there.

        Raises:
            ValueError: if an argument is out of its range, the algebra has no such method, or the Hamiltonian has no value
                at the start; the message names the part of the formula that has none, and the state.
            IntegrationError: if a step fails, or an invariant has no value later, and the times are given by `t`.
            MemoryError: if there is no room for the samples.

        Warns:
            RuntimeWarning: if a step turns the motion by more than 1 rad, or the estimated error is above 1e-3.

        Example:
            >>> import numpy as np
            >>> body = System("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2")
            >>> run = body.solve([1, 2, 0.5], np.linspace(0, 10, 101))
            >>> run.y.shape, run["Pi3"].shape, run.deviation("c1") < 1e-13
            ((3, 101), (101,), True)
        """
        if t is not None:
            return self._solve_at(y0, t, step, end, (formulation, scheme, tolerance), (every, events), path, estimate)
        if step is None or end is None:
            raise ValueError("write either t, or step and end")
        step, end = course(step, end)
        native = self._on_path(path)
        run = self._run(y0, step, (formulation, scheme, tolerance), native)
        watched = self._watched(events)
        columns = native.follow(run.setting, end, whole("every", every, 1), watched)
        repeated = run.steps(columns.times) if flag("estimate", estimate) else 0
        error = warn_of_accuracy(native, run.setting, repeated, 3)
        self._warn_of_end(columns.states, 3)
        symbols = (self.invariants, self.kept)
        return self._solved(solution(columns, symbols, run, error, has_events=events is not None))

    def _solve_at(self, y0: Optional[State], t: ArrayLike, step: Any, end: Any, names: Any, others: tuple[int, Events], path: Optional[int], estimate: bool) -> Solution:
        times = array("t", t)
        if end is not None or others != (1, None):
            raise ValueError("end, every and events go with step, not with t: write step and end instead of t")
        if times.ndim != 1 or times.size < 2 or not any(is_course(sign * times) for sign in (1, -1)):
            raise ValueError("t must be a list of times from 0 on that do not decrease, or that do not increase")
        last = float(times[-1])
        if step is None:
            step = last / (times.size - 1)
            if np.abs(times - step * np.arange(times.size)).max() > 1e-9 * abs(last):
                raise ValueError("step is missing: the times t are not equally spaced from 0")
        # Times that are all 0 have no direction, and make no step.
        step, _ = course(step, last or step)
        native = self._on_path(path)
        run = self._run(y0, step, names, native)
        if isinstance(native, _native.System):
            native.require_inputs()
        states = native.states_at(run.setting, times.tolist())
        error = warn_of_accuracy(native, run.setting, run.steps(times) if flag("estimate", estimate) else 0, 4)
        self._warn_of_end(states, 4)
        try:
            values = self.invariant_values(states.T, times)
        except ValueError as none:
            # At the start they have values, or there would be no states.
            raise IntegrationError(*none.args) from None
        return self._solved(solution_at(times, states, values, self.kept, run, error))

    def section(
        self,
        y0: Optional[State],
        surface: Function,
        *,
        value: float = 0.0,
        direction: int = 1,
        step: float,
        end: float,
        most: Optional[int] = None,
        scheme: str = "gauss-8",
        formulation: Optional[str] = None,
        path: Optional[int] = None,
    ) -> Crossings:
        """Returns the points at which a function of the state and the time passes a value: a Poincare section.

        A function of the time alone, such as "sin(2*t)", gives a stroboscopic section, once in each period. With noise there is no other
        one: a path passes a surface of coordinates again and again in any time, however short, and where depends on the step. The start
        is no crossing, even if it lies on the surface.

        Args:
            y0: the state at t = 0, as for `solve`; None for the start that the system was made with.
            surface: a coordinate, a formula in the coordinates, the time `t` and the inputs, or a Python function of the coordinates, or
                of them and the time. An angle, such as "atan2(Gamma2, Gamma1)", passes its value once per turn.
            value: its value on the surface.
            direction: 1 for crossings upwards in time, -1 for crossings downwards, 0 for both. A run backward in time finds
                the points of the same section.
            most: the number of crossings after which the run ends; None for no bound.

        The other arguments are those of `solve`.

        Raises:
            ValueError: if an argument is out of its range, or the function or the Hamiltonian has no value at the start.
            IntegrationError: if a step fails, or the function has no value later.
        """
        step, end = course(step, end)
        native = self._on_path(path)
        run = self._run(y0, step, (formulation, scheme, 0.0), native)
        # Events have the direction along the run.
        way = int(choice("direction", direction, (1, -1, 0)) * math.copysign(1, step))
        bound = 0 if most is None else whole("most", most, 1)
        warn_of_accuracy(native, run.setting, 0, 3)
        function = surface_source(surface, real("value", value), self._names, self._parameters)
        return crossings(native.follow(run.setting, end, NEVER, [(function, way, bound)]))

    def _formulation_of_tangents(self) -> str:
        """The formulation of tangent vectors unless another one is asked for: without fibres, where there is one with every scheme."""
        return "reduced" if "reduced" in self.formulations and not self._system.is_open else "direct"

    def _warn_of_end(self, states: Floats, stacklevel: int) -> None:
        """Warns about invariants of which a run has used up the digits; the states are rows."""
        warning = self._system.warning_of_end(states[0].tolist(), states[-1].tolist()) if len(states) else None
        if warning is not None:
            warnings.warn(warning, RuntimeWarning, stacklevel=stacklevel + 1)

    def _watched(self, events: Events) -> list[NativeEvent]:
        return native_events(events, self._names, self._parameters)

    def _solved(self, run: Solution) -> Solution:
        return run

    def _named(self, states: Floats, name: str) -> Floats:
        """Returns the rows of a coordinate or of a vector of coordinates, by name, from states in columns."""
        return rows_of(self._names, states, name)

    def _on_path(self, path: Optional[int]) -> _native.System:
        return self._system if path is None else self._system.on_path(whole("path", path, 0))

    def _run(
        self, y0: Optional[State], step: float, method: tuple[Any, Any, Any], native: Optional[_native.System] = None
    ) -> Run:
        return Run(native or self._system, (self._start(y0).tolist(), step, self._method(*method)), self._names)


def is_course(times: Floats) -> bool:
    """Returns whether times begin at 0 or later and do not decrease."""
    return bool(times[0] >= 0 and (np.diff(times) >= 0).all())
