#include "hgp/api/session/split_model.h"

#include <algorithm>

#include "hgp/api/request/mirror_request.h"
#include "hgp/features/feature_splits.h"

namespace hgp::api {
namespace {

/// The edges and their images in another component or the same one, each once.
void addImages(const TriMesh& from, const std::vector<EdgeId>& edges, const TriMesh& to,
               const Mirror& mirror, std::vector<EdgeId>& out) {
  for (EdgeId e : std::vector<EdgeId>(edges))
    out.push_back(to.edge(mirror.image.halfedge[from.halfedge(e)]));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

/// choose(component, its features), for the components of which `isAsked` is set; on both sides of a plane across which the
/// map is to be symmetric.
template <class Choose>
std::vector<std::vector<SplitPlace>> placesOf(const Model& model, const Request& request,
                                              const std::vector<char>& isAsked, const char* reason,
                                              const Choose& choose) {
  std::vector<std::vector<SplitPlace>> places(model.components.size());
  for (std::size_t p = 0; p < places.size(); ++p) {
    const TriMesh& mesh = model.components[p].mesh;
    const ComponentRequest& asked = request.components[p];
    const Mirror* mirror = asked.mirror.get();
    std::vector<EdgeId> edges;
    if (mirror && mirror->of >= 0) {  // what the first of the pair has
      const auto& first = places[at(mirror->of)];
      if (!first.empty())
        addImages(model.components[at(mirror->of)].mesh, first[0].edges, mesh, *mirror, edges);
    } else if ((mirror || !asked.spec.features.empty()) && isAsked[p]) {
      edges = choose(model.components[p], asked);
      if (mirror) addImages(mesh, edges, mesh, *mirror, edges);
    }
    if (!edges.empty()) places[p].push_back({reason, std::move(edges)});
  }
  return places;
}

bool isPolygonFile(const Model& model) {
  return std::string_view(model.document->outputFormat()) == "obj";
}

/// Chords at vertices that were added.
struct NewChords {
  int verticesBefore;

  std::vector<EdgeId> operator()(const ModelComponent& component,
                                 const ComponentRequest& asked) const {
    std::vector<EdgeId> edges = chords(component.mesh, asked.spec.features);
    std::erase_if(edges, [&](EdgeId e) {
      const HalfedgeId h = component.mesh.halfedge(e);
      return component.vertex[component.mesh.tail(h)].i < verticesBefore &&
             component.vertex[component.mesh.head(h)].i < verticesBefore;
    });
    return edges;
  }
};

std::vector<EdgeId> crowdedOf(const ModelComponent& component, const ComponentRequest& asked) {
  return edgesOfCrowded(component.mesh, asked.spec.features);
}
std::vector<EdgeId> chordsOf(const ModelComponent& component, const ComponentRequest& asked) {
  return chords(component.mesh, asked.spec.features);
}
std::vector<EdgeId> aroundOf(const ModelComponent& component, const ComponentRequest& asked) {
  return edgesAround(component.mesh, asked.spec.features);
}
std::vector<EdgeId> acrossOf(const ModelComponent& component, const ComponentRequest& asked) {
  return asked.mirror ? edgesAcross(component.mesh, asked.mirror->image) : std::vector<EdgeId>();
}

}  // namespace

bool isTooLargeToSplit(const Model& split) {
  return split.source().mesh.triangles.size() > std::size_t{kLargestRefinement};
}

bool isCrowded(const Model& model, const Request& request) {
  if (crossesPlane(model, request)) return true;
  for (std::size_t p = 0; p < model.components.size(); ++p)
    if (!edgesOfCrowded(model.components[p].mesh, request.components[p].spec.features).empty())
      return true;
  return false;
}

SplitModel::SplitModel(const Model& m, const Request& r)
    : model(&m), request(&r), crossesPlane(api::crossesPlane(m, r)) {}

Status SplitModel::split(Splits splits, const std::vector<char>& isOpen) {
  const auto step = [&](const std::vector<char>& isAsked, const char* reason, const auto& choose) {
    return splitEdges(placesOf(*model, *request, isAsked, reason, choose));
  };
  const std::vector<char> all(isOpen.size(), 1);
  if (Status done = step(all, "edges across the plane", acrossOf); !done) return done;
  const int before = static_cast<int>(model->source().mesh.positions.size());
  if (Status done = step(all, "triangles between features", crowdedOf); !done) return done;
  if (splits == Splits::kCrowded) return step(all, "edges between features", NewChords{before});
  if (Status done = step(isOpen, "edges between features", chordsOf); !done) return done;
  if (splits == Splits::kChords) return Done{};
  return step(isOpen, "triangles at features", aroundOf);
}

Status SplitModel::splitEdges(const Places& places) {
  if (std::all_of(places.begin(), places.end(), [](const auto& list) { return list.empty(); }))
    return Done{};
  Result<RefinedModel> next = refine(*model, places);
  if (!next && !isPolygonFile(*model)) {
    Result<Model> polygons = modelOfPolygons(*model, Note("split-as-polygons"));
    if (!polygons) return polygons.error();
    RefinedModel same{std::move(*polygons), {}, {}};
    same.facts.verticesBefore = static_cast<int>(model->source().mesh.positions.size());
    if (Status done = take(std::move(same)); !done) return done;
    next = refine(*model, places);
  }
  if (!next) return next.error();
  if (facts.edges == 0) {
    facts = next->facts;
  } else {
    facts.edges += next->facts.edges;
    facts.places.insert(facts.places.end(), next->facts.places.begin(), next->facts.places.end());
  }
  return take(std::move(*next));
}

Status SplitModel::take(RefinedModel next) {
  const std::vector<std::optional<FrameField>> none(model->components.size());
  Result<Request> features = carryOver(*model, *request, none, next);
  if (!features) return features.error();
  features->plane = request->plane;
  if (Status done = setMirrors(next.model, *features); !done) return done;
  refined = std::move(next);
  carried = std::move(*features);
  model = &refined->model;
  request = &*carried;
  return Done{};
}

}  // namespace hgp::api
