// Faults of one line that the tests must notice: signs, off-by-one, tolerances × 1000, rows dropped,
// options ignored, repairs that do nothing. `find` stands exactly once in the file; where it no longer
// does, scripts/mutate fails and the fault wants to be looked at again.
//
// Each names the test programs that see it, the likeliest first; without a name, that of its module.
// Those of `short` are planted by every scripts/test; the test named there sees the fault and is tried
// before all others.

const fault = (file, find, put, more = {}) => ({ file: `core/hgp/${file}`, find, put, ...more });
const short = (seenBy) => ({ short: true, seenBy });

export const faults = [
  // base, text
  fault(
    'base/turns.cpp',
    'case 1:\n      return {-s, c};',
    'case 1:\n      return {s, c};',
    short('Turns.RotationsAreOnTheCircleWithinOneRounding'),
  ),
  fault('base/turns.cpp', 'return a <= -kPi ?', 'return a < -kPi ?'),
  fault('base/float32.cpp', 'return static_cast<double>(rounded);', 'return (void)rounded, x;'),
  fault(
    'text/text.cpp',
    ' || !std::isfinite(value)) return false;',
    ') return false;',
    short('ReadDouble.RefusesWhatIsNoFiniteNumber'),
  ),
  fault('text/text.cpp', "(*answer.ptr == 'e' || *answer.ptr == 'E')", "(*answer.ptr == 'E')"),

  // api
  fault(
    'api/session/session_result.cpp',
    '!result.data_ || result.data_->surface != state_->surfaceHash()',
    '!result.data_',
    { programs: ['api'] },
  ),

  // mesh
  fault('mesh/topology.cpp', 'loop.crossed.push_back(h);', '', { programs: ['mesh', 'field'] }),
  fault('mesh/topology.cpp', 'if (!mesh.isBoundary(start) || isSeen[start])', 'if (isSeen[start])'),
  fault(
    'mesh/geometry.cpp',
    '+ kPi - geometry.direction[h]',
    '- geometry.direction[h]',
    short('Geometry.TransportAroundAVertexIsItsCurvature'),
  ),
  fault(
    'mesh/holonomy_spec.cpp',
    'report.have += *l;',
    'report.have -= *l;',
    short('HolonomySpec.OpenLoopsTakeWhatIsMissingWithinTheirBounds'),
  ),
  fault('mesh/holonomy_spec.cpp', 'return {floorHalf(low) + 1,', 'return {floorHalf(low),'),
  fault('mesh/holonomy_spec.cpp', '2LL * c.k >=', '2LL * c.k >'),
  fault('mesh/defects.cpp', 'if (fanCount[at(v)] > 1)', 'if (fanCount[at(v)] > 2)'),
  fault('mesh/repair/repair.cpp', 'isFlipped) < 0.0', 'isFlipped) > 0.0'),
  fault(
    'mesh/repair/repair.cpp',
    'if (options.split) splitNonManifold(result, oneSided);',
    '',
    short('Repair.AMoebiusBandIsCutOnceOrStaysADefect'),
  ),
  fault(
    'mesh/repair/repair.cpp',
    'if (options.orient) oneSided = orientFaces(result, options.split);',
    '',
  ),
  fault('mesh/repair/repair.cpp', 'if (options.degenerate) leaveOut(result);', ''),
  fault('mesh/repair/repair_split.cpp', 'if (owner[at(v)] == fan) continue;', 'continue;'),

  // linalg
  fault(
    'linalg/factor/schur_lu.cpp',
    'L[row] += values',
    'L[row] -= values',
    short('SchurLu.ExtensionMakesEliminatedRowsVanishAndSchurGivesTheOthers'),
  ),
  fault(
    'linalg/factor/schur_lu.cpp',
    'kPivotTolerance * addColumn',
    '1e3 * kPivotTolerance * addColumn',
  ),
  fault('linalg/factor/partial_cholesky.cpp', 'x(k, 0) = -c[', 'x(k, 0) = c['),
  fault(
    'linalg/ordering/minimum_degree.cpp',
    'for (std::size_t i = 1; i < left.size(); ++i) {',
    'for (std::size_t i = left.size(); i < left.size(); ++i) {',
  ),

  // field
  fault(
    'field/open_turning.cpp',
    'coneCurvature(-*spec',
    'coneCurvature(*spec',
    short('ConeMetric.SolvesThePoissonEquationOfTheAskedCurvature'),
  ),
  fault(
    'field/prescribed_field.cpp',
    'omega[e] += surface.weight[e]',
    'omega[e] -= surface.weight[e]',
  ),
  fault(
    'field/nearest_lattice_point.cpp',
    'if (square >= shortest) {',
    'if (square >= 0.9 * shortest) {',
  ),
  fault(
    'field/open_turning.cpp',
    'b[i - 1] = u(anchor, 0) - u(node, 0);',
    'b[i - 1] = u(node, 0) - u(anchor, 0);',
  ),
  fault('field/frame_field.cpp', 'return own == h ? angle : -angle;', 'return angle;'),
  fault('field/frame_field.cpp', '+ 0.5 - kTieShare', '+ 0.5 - 1e3 * kTieShare - 0.2'),
  fault(
    'field/filled_surface.cpp',
    '[static_cast<std::size_t>(node)] = 2.0 * kPi;',
    '[static_cast<std::size_t>(node)] = 0.0;',
  ),
  fault(
    'field/read_holonomy.cpp',
    'field.matching[mesh.twin(found)] = -sign * m.turn;',
    'field.matching[mesh.twin(found)] = sign * m.turn;',
  ),
  fault('cones/cancel_cones.cpp', '++defect[other];', ''),
  fault('cones/cancel_cones.cpp', 'spread(mesh, q, defect, search);', ''),

  // cut, system
  fault(
    'cut/seam_rotation.cpp',
    'n[f] + field.matching[h]',
    'n[f] - field.matching[h]',
    short('CutMesh.IsADisk'),
  ),
  fault(
    'cut/seam_graph.cpp',
    'trimLeaves(mesh, surface, graph, terminals, isSeam);\n  return',
    'return',
  ),
  fault('cut/seam_graph.cpp', 'x.loop > y.loop', 'x.loop < y.loop'),
  fault('seams/chains.cpp', '(degree[v] != 2 || mesh.isBoundary(v))', 'degree[v] != 2', {
    programs: ['seams', 'cut'],
  }),
  fault(
    'system/harmonic.cpp',
    'rotation(-unknowns.turn',
    'rotation(unknowns.turn',
    short('HarmonicRows.AreThePapersFormulaForEveryDegree'),
  ),
  fault('system/harmonic.cpp', ' && !isCone[v]', ''),
  fault('system/reduced_unknowns.cpp', 'one - Ring::turned(', 'one + Ring::turned('),
  fault(
    'system/reduced_unknowns.cpp',
    'relations.push_back(closure(v).shift);',
    'if (!relations.empty()) relations.push_back(closure(v).shift);',
  ),
  fault('system/weights.cpp', 'portable::tan(0.5 *', 'portable::tan(0.49 *'),
  fault('seams/relations.cpp', 'push_back({other, -factor})', 'push_back({other, factor})'),

  // what no test noticed once
  fault(
    'verify/verdict.cpp',
    'if (reason.count++ > 0) continue;',
    'if (reason.count++ > 1) continue;',
  ),
  fault('io/gltf/decode/accessor.cpp', 'value / 32767.0', 'value / 32768.0'),
  fault(
    'io/polygon/obj_scanner.cpp',
    'index += index < 0 ? static_cast<std::int64_t>(out_.uv.size()) : -1;',
    'index += index < 0 ? static_cast<std::int64_t>(out_.uv.size()) - 1 : -1;',
  ),
  fault('optimize/fold_barrier.cpp', 'e.ab = -4.0 * a * b * fdd;', 'e.ab = 4.0 * a * b * fdd;'),
  fault('verify/exact_seams.cpp', 'a.high == b.high && a.low == b.low', 'a.high == b.high'),
  fault('system/harmonic_residual.cpp', 'std::sqrt(2.0) * gridStep', '1e3 * gridStep'),
  fault(
    'grid/lattice_snapper.cpp',
    'return Lattice<Ring>::fits(p, exponent, numbers);',
    'return p == p;',
    { programs: ['grid', 'api'] },
  ),
  fault(
    'parametrize/strategy/found.cpp',
    '!best || distanceToCertified(*attempt) < distanceToCertified(*best)',
    'true',
  ),
  fault(
    'api/stored/stored_map.cpp',
    'components[p].certificate.precision == options.precision &&\n               isSame(stored, components[p].map)',
    'components[p].certificate.precision == options.precision',
  ),

  // socp
  fault(
    'socp/second_order_cone.cpp',
    'Vector3 reflect(const Vector3& s) { return {s[0], -s[1], -s[2]}; }',
    'Vector3 reflect(const Vector3& s) { return {s[0], -s[1], s[2]}; }',
    short('NesterovTodd.ScalesBothPointsToTheSame'),
  ),
  fault('socp/second_order_cone.cpp', 'if (ds[0] < 0.0)', 'if (ds[0] > 0.0)'),

  // optimize
  fault(
    'optimize/exact_form.cpp',
    'portable::exp(-in_.options.u[v])',
    'portable::exp(in_.options.u[v])',
    short('Program.NoFeasibleNeighbourOfTheExactFormIsBetter'),
  ),
  fault(
    'optimize/penalty_form.cpp',
    'portable::exp(-in.options.u[v])',
    'portable::exp(in.options.u[v])',
  ),
  fault('system/face_rows.cpp', 'constraint.h << margin', 'constraint.h << -margin'),
  fault(
    'optimize/program_terms.cpp',
    'portable::polar(weight, in.seams.frameAngle[f])',
    'portable::polar(weight, -in.seams.frameAngle[f])',
  ),
  fault('optimize/frames.cpp', 'if (isMarked[v] || mesh.isBoundary(v)) {', 'if (isMarked[v]) {'),
  fault(
    'field/angle_structure.cpp',
    'size()) -\n        turnAngle(spec.turning[i], spec.q);',
    'size()) +\n        turnAngle(spec.turning[i], spec.q);',
  ),
  fault(
    'parametrize/strategy/frames_of_metric.cpp',
    'seams.frameAngle[f] -= portable::arg(similarity);',
    'seams.frameAngle[f] += portable::arg(similarity);',
  ),
  fault(
    'mesh/angle_shortage.cpp',
    'asked_[at(v.i)] = 2LL * question.k[v] * unit_;',
    'asked_[at(v.i)] = (2LL * question.k[v] - 1) * unit_;',
  ),
  fault('cones/make_room.cpp', '++k[*receiver];', '--k[*receiver];'),
  fault(
    'optimize/frame_fixing.cpp',
    'turn += seams.rotation[mesh.twin(h)];',
    'turn += seams.rotation[h];',
  ),
  fault(
    'optimize/program.cpp',
    'solution.y[a][0] > solution.y[b][0]',
    'solution.y[a][0] < solution.y[b][0]',
  ),

  // verify: the certificate's own rules
  fault(
    'verify/orientation.cpp',
    'sum.add(a[1], c[0], false);',
    'sum.add(a[1], c[0], true);',
    short('Orientation.AgreesWithExactIntegersOnNearlyFlatTriangles'),
  ),
  fault('verify/orientation.cpp', 'if (det > bound) return 1;', 'if (det > 0) return 1;'),
  fault(
    'verify/angles.cpp',
    'cone.measured != cone.asked || cone.isTooFar()',
    'cone.measured != cone.asked',
  ),
  fault('verify/angles.cpp', 'measured.isWrong = measured.isTooFar() ||', 'measured.isWrong ='),
  fault(
    'verify/angles.cpp',
    'out.allowed = std::min(',
    'out.allowed = 1e3 * std::min(',
    short('Angles.AreMeasuredInRadiansWhateverTheOrder'),
  ),
  fault(
    'verify/angles.cpp',
    'turning += kPi - sum',
    'turning += sum',
    short('Certificate.PassesAConvexDisk'),
  ),
  fault('verify/angles.cpp', 'facts.turnSum += l;', ''),
  fault(
    'verify/seams.cpp',
    'const double strict = rule.tolerance',
    'const double strict = 1e3 * rule.tolerance',
  ),
  fault('verify/seams.cpp', 'seam.residual < kRotationShare * toNext', 'seam.residual >= 0'),
  fault('verify/verdict.cpp', 'checkHandles(mesh, facts, loops, options, reasons);\n', '\n'),
  fault('verify/verdict.cpp', 'checkIntegers(facts, reasons);\n', '\n'),
  fault('verify/overlap.cpp', 'twice += count > 1;', 'twice += count > 2;'),

  // prescription, io
  fault(
    'prescription/cone_lists.cpp',
    'const double k = q * (1 - curvature',
    'const double k = q * (1 + curvature',
    { programs: ['io'], ...short('Curvatures.AreExactOrRefused') },
  ),
  fault('prescription/cone_lists.cpp', 'if (index != 0) out.cones', 'if (index > 0) out.cones', {
    programs: ['io'],
  }),
  fault(
    'prescription/cones_json.cpp',
    'm.integer((*cones)[i], "k", cone.k, true);',
    'm.integer((*cones)[i], "k", cone.k, false);',
    { programs: ['io'] },
  ),
  fault(
    'io/weld.cpp',
    'if (d <= tolerance) {',
    'if (d <= 1000 * tolerance) {',
    short('Weld.NearKeepsApartWhatIsFartherThanTheTolerance'),
  ),
  fault('io/round_uv.cpp', 'if (candidate > bestArea) {', 'if (candidate < bestArea) {'),
  fault('io/polygon/polygon_uv.cpp', '< kQuarterTurn)', '< 1000 * kQuarterTurn)'),

  // grid
  fault('grid/align.cpp', 'accepts_ ? accepts_(*map) :', 'accepts_ && false ? accepts_(*map) :'),
  fault('quads/multiple_edges.cpp', 'a == b ||', 'a == b &&'),
  fault('cones/place_cones.cpp', 'metric.q() - smallestK', 'metric.q() - smallestK + 1'),
  fault('grid/integer_choice.cpp', 'form_->rounded(spread(w0))', 'form_->rounded(w0)'),
  fault('grid/integer_choice.cpp', 'now.second) < kZero;', 'now.second) > kZero;'),
  fault(
    'grid/integer_form.cpp',
    '= w[at(step->by)] - step->factor',
    '= w[at(step->by)] + step->factor',
  ),
  fault(
    'grid/cone_pairs.cpp',
    'return {std::move(pairs), triangles()};',
    'return {std::move(pairs), {}};',
  ),

  // improve, parametrize, api
  fault('improve/improve.cpp', 'x_ = std::move(moved);', '', {
    programs: ['improve', 'parametrize'],
  }),
  fault('improve/energy.cpp', 'kKnee = 2.0 * 0.02 * 0.02;', 'kKnee = 2e9 * 0.02 * 0.02;'),
  fault('system/reduced_unknowns.cpp', '- R * value(cut.copy[left]);', '- value(cut.copy[left]);'),
  fault(
    'parametrize/after/solution.cpp',
    'return improveOnGrid(mesh, options, heldByGrid(setup, options.grid.mode),\n                       aligned.multiplyAddsLeft, mapped, result);',
    'return Done{};',
    short('GridImprovement.GainsWhileEveryIntegerStaysWhereAlignmentPutIt'),
  ),
  fault(
    'parametrize/after/solution.cpp',
    'for (const int unknown : setup.unknowns.chainUnknown) hold(unknown);',
    '',
  ),
  fault(
    'parametrize/after/solution.cpp',
    'if (mode == GridMode::kQuad)',
    'if (mode == GridMode::kTile)',
  ),
  fault(
    'parametrize/parametrize.cpp',
    'return count >= kUnevenShare * mesh.faceCount();',
    'return false;',
  ),
  fault('mesh/geometry.cpp', 'x = std::sqrt(x * x + kEvening * kEvening);', 'x += 0.0;'),
  fault('parametrize/convex.cpp', 'walked += geometry.length[h];', 'walked += 1.0;'),
  fault(
    'api/stored/stored_map.cpp',
    '(1 - 1e-7) / size',
    '1.001 / size',
    short('Session.ScalesAsAsked'),
  ),
  fault('api/stored/stored_map.cpp', 'if (mean > 0) moveAndScale(map.uv, {0, 0}, 1 / mean);', ''),
  fault('api/request/request.cpp', 'reduceTurn(h.r, asked_.q)', 'reduceTurn(-h.r, asked_.q)'),
  fault('api/request/request.cpp', 'if (anchored >= 0) loop = anchored;', ''),
  fault('api/model/load_model.cpp', 'if (edits.faces.empty()) return Done{};', 'return Done{};'),
];
