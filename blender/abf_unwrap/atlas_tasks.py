# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tasks that make atlases: unwrap along seams, find seams, repair islands, pack. Nothing here needs Blender."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from . import module
from .certificate import faults_of_rounding
from .disk_tasks import PinnedIslands, flatten_pinned_islands
from .job import Progress, part_of
from .mesh_arrays import BadInput, MeshArrays, MeshResult, TaskResult, edge_flags


@dataclass(frozen=True)
class Packing:
    """How islands are placed."""

    resolution: int = 1024
    gutter: int = 0  # texels; 0: as many as suit the resolution
    texels_per_unit: float = 0  # 0: the islands fill one square; otherwise they take as many tiles as they need
    block: int = 1  # texels along the sides of blocks that no two islands share

    def keywords(self) -> dict[str, Any]:
        gutter = {"gutter": self.gutter} if self.gutter else {}
        return {
            "resolution": self.resolution, "texels_per_unit": self.texels_per_unit, "block": self.block, **gutter
        }


@dataclass(frozen=True)
class SeamChoice:
    """Where seams are put."""

    purpose: str = "texture"
    seams: str = "auto"
    stretch_bound: float = 0  # 0: as suits the purpose
    keep_marked: bool = True

    def keywords(self) -> dict[str, Any]:
        bound = {"stretch_bound": self.stretch_bound} if self.stretch_bound else {}
        return {"purpose": self.purpose, "seams": self.seams, **bound}


def usable_seams(mesh: MeshArrays) -> np.ndarray:
    """Pairs of vertices: the marked seams on chosen faces."""
    of_chosen = np.zeros(len(mesh.edges), bool)
    of_chosen[mesh.corner_edges[mesh.chosen[mesh.corner_faces()]]] = True
    return mesh.edges[mesh.seams & of_chosen]


def make_atlas(
    meshes: list[MeshArrays], progress: Progress, with_seams: bool, with_uv: bool, **keywords: Any
) -> list[Any]:
    """Atlases of all meshes with a chosen face, in common pages; None for the others."""
    used = [mesh for mesh in meshes if mesh.chosen.any()]
    if not used:
        raise BadInput("No face is selected")
    abf = module.load()

    def argument(values: list[Any]) -> Any:
        return values if len(used) > 1 else values[0]

    try:
        made = abf.atlas(
            argument([mesh.vertices for mesh in used]),
            argument([mesh.polygons for mesh in used]),
            ignored_faces=argument([~mesh.chosen for mesh in used]),
            marked_seams=argument([usable_seams(mesh) for mesh in used]) if with_seams else None,
            uv=argument([mesh.uv for mesh in used]) if with_uv else None,
            progress=progress,
            **keywords,
        )
    except abf.MeshError as error:
        mesh = used[error.mesh]
        number = next(k for k, each in enumerate(meshes) if each is mesh)
        text = with_names(error.message, used)
        text = text if mesh.name in text else f"{mesh.name}: {text}"
        raise BadInput(text, [(number, faces_of(error, mesh))]) from error
    except ValueError as error:
        seam = re.search(r"(?:'mesh (\d+)': )?marked_seams\[(\d+)\]", str(error))
        if seam is None:
            raise
        mesh = used[int(seam[1] or 0)]
        number = next(k for k, each in enumerate(meshes) if each is mesh)
        raise unusable_seam(mesh, number, usable_seams(mesh)[int(seam[2])]) from error
    atlases = iter(made if len(used) > 1 else [made])
    return [next(atlases) if mesh.chosen.any() else None for mesh in meshes]


def unusable_seam(mesh: MeshArrays, number: int, ends: np.ndarray) -> BadInput:
    """The seam lies only at faces that the module leaves out."""
    edge = np.flatnonzero(edge_flags(mesh.edges, ends, len(mesh.vertices)))
    faces = np.unique(mesh.corner_faces()[np.isin(mesh.corner_edges, edge)])
    text = f"{mesh.name}: the seam between vertices {ends[0]} and {ends[1]} is at broken faces: clear it or repair them"
    return BadInput(text, [(number, faces)])


def with_names(text: str, meshes: list[MeshArrays]) -> str:
    """What the module says of one or several meshes, with the names of the objects."""
    if len(meshes) == 1:
        return text.replace("'mesh'", f"'{meshes[0].name}'")
    return re.sub(r"\bmesh (\d+)\b", lambda found: meshes[int(found[1])].name, text)


def faces_of(error: Any, mesh: MeshArrays) -> np.ndarray:
    """The faces that an error of the module is about, or if it is about vertices only, the chosen faces at them."""
    if len(error.faces):
        return np.asarray(error.faces, np.int64)
    at_vertices = mesh.corner_faces()[np.isin(mesh.corner_vertices, error.vertices)]
    return np.unique(at_vertices[mesh.chosen[at_vertices]])


def result_of(mesh: MeshArrays, atlas: Any) -> MeshResult:
    """The coordinates of an atlas, without seams."""
    if atlas is None:
        return MeshResult(np.full((len(mesh.corner_vertices), 2), np.nan))
    has_chart = np.asarray(atlas.face_chart) >= 0
    uv = np.array(atlas.uv, float)
    uv[~has_chart[mesh.corner_faces()]] = np.nan
    return MeshResult(uv, left_out=np.flatnonzero(mesh.chosen & ~has_chart), faulty=faults_of_rounding(mesh, uv))


def message_of(meshes: list[MeshArrays], atlases: list[Any], verb: str) -> str:
    """One line on what came out."""
    made = [(mesh, atlas) for mesh, atlas in zip(meshes, atlases) if atlas is not None]
    charts = {(k, chart) for k, (_, atlas) in enumerate(made) for chart in np.unique(atlas.face_chart) if chart >= 0}
    report = made[0][1].report
    figures = [f"{verb} {len(charts)} island{'s' if len(charts) != 1 else ''}"]
    contents = report.get("atlas") or {}
    if contents.get("l2_stretch") is not None:
        figures.append(f"stretch {contents['l2_stretch']:.3f}")
    packing = contents.get("packing") or {}
    share = packing.get("covered_share")
    if packing.get("pages", 1) > 1:
        figures.append(f"{packing['pages']} tiles")
    elif share is not None:
        figures.append(f"{100 * share:.0f} % of the square covered")
    if contents.get("injective"):
        figures.append("no flips and no overlaps")
    return ", ".join(figures)


def notes_of(meshes: list[MeshArrays], atlases: list[Any]) -> list[str]:
    """What the module noticed, such as repairs."""
    made = [(mesh, atlas) for mesh, atlas in zip(meshes, atlases) if atlas is not None]
    notes = made[0][1].report.get("notes") or [] if made else []
    return [with_names(note, [mesh for mesh, _ in made]) for note in notes]


def unwrap(meshes: list[MeshArrays], purpose: str, packing: Packing, progress: Progress) -> TaskResult:
    """Unwraps along the marked seams, and cuts further only what cannot be unwrapped otherwise. Islands with two pinned
    vertices or more stay where these are; the others are packed."""
    pinned = [flatten_pinned_islands(mesh, k, part_of(progress, k, 2 * len(meshes))) for k, mesh in enumerate(meshes)]
    rest = [replace(mesh, chosen=mesh.chosen & ~done.faces) for mesh, done in zip(meshes, pinned)]
    has_pins = any(done.number for done in pinned)
    if has_pins and not any(mesh.chosen.any() for mesh in rest):
        atlases = [None] * len(meshes)
    else:
        atlases = make_atlas(
            rest,
            part_of(progress, 1, 2) if has_pins else progress,
            with_seams=True,
            with_uv=False,
            purpose=purpose,
            stretch_bound=math.inf,
            seam_price=math.inf,
            **packing.keywords(),
        )
    results = [result_of(mesh, atlas) for mesh, atlas in zip(rest, atlases)]
    for result, done in zip(results, pinned):
        corners = ~np.isnan(done.uv[:, 0])
        result.uv[corners] = done.uv[corners]
        result.faulty = np.concatenate([result.faulty, *done.faulty])
    messages = [pinned_message(pinned)] if has_pins else []
    messages += [message_of(meshes, atlases, "Unwrapped")] if any(atlases) else []
    return TaskResult(results, ". ".join(messages), notes_of(rest, atlases))


def pinned_message(pinned: list[PinnedIslands]) -> str:
    number = sum(done.number for done in pinned)
    return f"Unwrapped {number} pinned island{'s' if number != 1 else ''} in place"


def find_seams_and_unwrap(
    meshes: list[MeshArrays], choice: SeamChoice, packing: Packing, progress: Progress
) -> TaskResult:
    """Finds seams, unwraps along them, packs, and marks them. Pins are not respected: islands are new ones."""
    atlases = make_atlas(
        meshes, progress, with_seams=choice.keep_marked, with_uv=False, **choice.keywords(), **packing.keywords()
    )
    results = [result_of(mesh, atlas) for mesh, atlas in zip(meshes, atlases)]
    for mesh, atlas, result in zip(meshes, atlases, results):
        if atlas is not None:
            result.seams = new_seams(mesh, atlas.seams)
    return TaskResult(results, message_of(meshes, atlases, "Marked seams and unwrapped"), notes_of(meshes, atlases))


def new_seams(mesh: MeshArrays, pairs: np.ndarray) -> np.ndarray:
    """Seams of the chosen faces become the given ones; those between other faces stay."""
    corner_chosen = mesh.chosen[mesh.corner_faces()]
    of_chosen, of_others = np.zeros((2, len(mesh.edges)), bool)
    of_chosen[mesh.corner_edges[corner_chosen]] = True
    of_others[mesh.corner_edges[~corner_chosen]] = True
    stay = mesh.seams & (of_others | ~of_chosen)
    return stay | (edge_flags(mesh.edges, pairs, len(mesh.vertices)) & of_chosen)


def need_uv(meshes: list[MeshArrays]) -> None:
    for number, mesh in enumerate(meshes):
        if not mesh.chosen.any():
            continue
        if mesh.uv is None:
            raise BadInput(f"{mesh.name} has no UV layer: unwrap it first")
        faces = mesh.corner_faces()[~np.isfinite(mesh.uv).all(axis=1)]
        faces = np.unique(faces[mesh.chosen[faces]])
        if len(faces):
            raise BadInput(
                f"{mesh.name}: face {faces[0]} has a texture coordinate that is not finite", [(number, faces)]
            )


def unfold(meshes: list[MeshArrays], packing: Packing, progress: Progress) -> TaskResult:
    """Makes islands that flip or overlap anew, without flips and overlaps, and packs all."""
    need_uv(meshes)
    atlases = make_atlas(meshes, progress, with_seams=False, with_uv=True, given_charts="repair", **packing.keywords())
    results = [result_of(mesh, atlas) for mesh, atlas in zip(meshes, atlases)]
    return TaskResult(results, message_of(meshes, atlases, "Unfolded"), notes_of(meshes, atlases))


def pack(meshes: list[MeshArrays], packing: Packing, progress: Progress) -> TaskResult:
    """Packs the islands of all meshes into one square, without changing their shapes."""
    need_uv(meshes)
    atlases = make_atlas(meshes, progress, with_seams=False, with_uv=True, given_charts="keep", **packing.keywords())
    results = [result_of(mesh, atlas) for mesh, atlas in zip(meshes, atlases)]
    return TaskResult(results, message_of(meshes, atlases, "Packed"), notes_of(meshes, atlases))
