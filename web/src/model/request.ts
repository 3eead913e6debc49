// What a map was asked with, to make or write it again.

import type { Solution, SolveRequest } from './types';

export function requestOf(solution: Solution): SolveRequest {
  const { prescription, settings, improve, frames, features } = solution;
  const { grid, cells, output, isDragged } = solution;
  return { prescription, settings, improve, frames, features, grid, cells, output, isDragged };
}
