"""Uses of the package that mypy --strict must accept, and to refuse: a line marked `wrong` has an error of that kind."""

from typing import Any

import numpy as np
import numpy.typing as npt

import hgp


def use(V: npt.NDArray[np.float64], F: npt.NDArray[np.int64]) -> float:
    m = hgp.parametrize(V, F, q=4, cones={12: 3, 40: 5}, cells=2000, improve="isometric")
    uv: npt.NDArray[np.float64] = m.uv
    fuv: npt.NDArray[np.int32] = m.fuv
    good: bool = m.certificate["certified"]
    layers: int = m.certificate["components"][0]["overlap"]["layers"]
    k: int = m.cones[12]
    notes: "list[str]" = m.save("out.glb", embed_cones=True)
    m = hgp.Mesh.load("mesh.obj").parametrize(progress=lambda p: p.fraction < 0.5)
    verdict = hgp.check(V, F, [(3, 4)])
    if not verdict["valid"] and "error" in verdict:
        print(verdict["error"]["message"])
    found: "npt.NDArray[np.int32]" = hgp.list_features(V, F, creases=30).edges
    m = hgp.parametrize(V, F, features=found)
    done = hgp.parametrize_file("scene.glb", "mapped.glb", features=hgp.list_features(V, F), keep_going=True)
    for one in done.meshes:
        print(one.mesh, one.report["certificate"]["certified"] if one.report else one.error)
    written: "list[str]" = hgp.combine([m], "out.glb")
    print(written, done.path)
    try:
        hgp.verify(V, F, uv, fuv, cones=m.cones)
    except hgp.PrescriptionError as error:
        place: "tuple[hgp.Place, ...]" = error.places
        print(place, good, layers, k, notes)
    return float(m.distortion().stretch.max())


def misuse(V: Any, F: Any) -> None:
    m = hgp.parametrize(V, F, method="fast")  # wrong: arg-type
    hgp.parametrize(V, F, Q=4)  # wrong: call-arg
    m.certificate["certifed"]  # wrong: typeddict-item
    m.cones[3] = 4  # wrong: index
    m.uv = m.uv  # wrong: misc
    hgp.parametrize_file("scene.glb")  # wrong: call-arg
    hgp.parametrize_file("a.glb", "b.glb").meshes[0].report["certificate"]  # wrong: index
