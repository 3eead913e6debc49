"""Small pictures of mapped surfaces, drawn with numpy alone."""

from __future__ import annotations

import struct
import zlib

import numpy as np
import numpy.typing as npt

from ._map import Map

SAMPLES = 200_000
Floats = npt.NDArray[np.float64]


def png(pixels: "npt.NDArray[np.uint8]") -> bytes:
    """An image of h × w × 3 as PNG."""
    height, width, _ = pixels.shape
    rows = np.zeros((height, 1 + 3 * width), np.uint8)
    rows[:, 1:] = pixels.reshape(height, -1)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = [chunk(b"IHDR", header), chunk(b"IDAT", zlib.compress(rows.tobytes(), 9)), chunk(b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def _turn() -> Floats:
    """From the mesh's axes to right, up and towards the viewer."""
    towards = np.array([0.45, 0.55, 0.8]) / np.linalg.norm([0.45, 0.55, 0.8])
    right = np.cross([0.0, 1.0, 0.0], towards)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(towards, right), towards])


def thumbnail(m: Map, size: int = 160) -> bytes:
    """The surface with a grid of its map as a PNG: each triangle as many points as its area asks for, nearest last."""
    corners = (m.vertices @ _turn().T)[m.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    total = float(lengths.sum())
    pixels = np.full((size, size, 3), 255, np.uint8)
    if not total > 0:
        return png(pixels)
    counts = np.ceil(SAMPLES * lengths / total).astype(np.int64) * (lengths > 0)
    face = np.repeat(np.arange(len(corners)), counts)
    random = np.random.default_rng(0)
    a, b = random.random(len(face)), random.random(len(face))
    outside = a + b > 1
    a[outside], b[outside] = 1 - a[outside], 1 - b[outside]
    weights = np.stack([1 - a - b, a, b], axis=1)
    points = np.einsum("nk,nkd->nd", weights, corners[face])
    uv = np.einsum("nk,nkd->nd", weights, m.uv[m.fuv[face]])

    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    scale = 0.94 * size / max(float((high - low)[:2].max()), 1e-300)
    at = np.rint((points - (low + high) / 2)[:, :2] * scale + size / 2).astype(np.int64).clip(0, size - 1)
    # About 24 lines across, whatever the scale of the map.
    spacing = float(np.sqrt(np.abs(_areas(m)).sum() / 2)) / 24
    lines = (np.abs(uv / max(spacing, 1e-300) - np.rint(uv / max(spacing, 1e-300))) < 0.09).any(axis=1)
    light = 0.35 + 0.65 * np.abs(normals[face, 2]) / lengths[face]
    colour = np.where(lines[:, None], [40, 60, 90], [238, 222, 190]) * light[:, None]
    order = np.argsort(points[:, 2], kind="stable")
    pixels[size - 1 - at[order, 1], at[order, 0]] = colour[order].astype(np.uint8)
    return png(pixels)


def _areas(m: Map) -> Floats:
    a, b, c = (m.uv[m.fuv[:, k]] for k in range(3))
    areas: Floats = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    return areas
