// SPDX-License-Identifier: Apache-2.0
// Pages of the surface, for a thread that draws.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/surface/surface_stream.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut::c {
namespace {

constexpr std::size_t kMaxLent = 4096;   // pages
constexpr std::size_t kMaxBlocks = 256;  // [blocks] received in one call, so that a call is short

class SurfaceObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::surface;

  /// @pre the simulation is idle
  explicit SurfaceObject(std::shared_ptr<SimulationObject> a_simulation)
      : simulation(std::move(a_simulation)),
        feed(std::make_shared<ChangeFeed>(simulation->simulation)),
        stream(simulation->simulation.workpiece()),
        bounds(simulation->simulation.workpiece().bounds()) {}
  ~SurfaceObject() override {
    SimulationObject& owner = *simulation;
    owner.retire(std::move(feed));
  }

  struct LentPage {
    std::uint64_t ticket = 0;  // 0: free
    SurfacePage page;
  };

  /// A free page, whose memory is reused.
  LentPage& free_page() {
    const auto found = std::find_if(pages.begin(), pages.end(), [](const auto& one) { return one->ticket == 0; });
    if (found != pages.end()) return **found;
    if (pages.size() == kMaxLent)
      throw Refusal(HAPTICUT_ERROR_FULL, "4096 pages of this surface are in use; call hapticut_surface_release_page.");
    return *pages.emplace_back(std::make_unique<LentPage>());
  }

  const std::shared_ptr<SimulationObject> simulation;
  std::shared_ptr<ChangeFeed> feed;
  SurfaceStream stream;
  const IndexBox bounds;
  std::vector<std::unique_ptr<LentPage>> pages;
  std::uint64_t tickets = 0;
};

void put_page(const SurfaceObject::LentPage& lent, const GridFrame& frame, hapticut_page& own) {
  static_assert(sizeof(SurfaceVertex) == sizeof(hapticut_vertex) &&
                offsetof(SurfaceVertex, material) == offsetof(hapticut_vertex, material) &&
                offsetof(SurfaceVertex, normal) == offsetof(hapticut_vertex, normal));
  const SurfacePage& page = lent.page;
  own.vertex_count = std::uint32_t(page.vertices.size());
  own.index_count = std::uint32_t(page.indices.size());
  std::copy(page.origin.begin(), page.origin.end(), own.origin);
  own.version = page.version;
  own.vertices = reinterpret_cast<const hapticut_vertex*>(page.vertices.data());
  own.indices = page.indices.data();
  put(Pose{frame.X_WV.rotation, frame.center(page.origin)}, own.X_WP);
  own.step = frame.voxel_size / SurfaceVertex::kStepsPerVoxel;
  own.ticket = lent.ticket;
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_surface_open(hapticut_simulation simulation, hapticut_surface* surface) {
  return within(IdleSimulation(simulation), [&](const auto& use) {
    require_argument(surface, "surface");
    use.pointer()->sweep();
    *surface = add_object(Kind::surface, std::make_shared<SurfaceObject>(use.pointer()));
  });
}

int hapticut_surface_poll(hapticut_surface surface, hapticut_page* page) {
  if (const int code = check_size(page, "page"); code != HAPTICUT_OK) return code;
  return within(Use<SurfaceObject>(surface), [&](const auto& use) -> int {
    if (page->struct_size < sizeof(hapticut_page))
      throw Refusal(HAPTICUT_ERROR_STRUCT_SIZE, "page->struct_size is too small for the ticket that releases a page.");
    ChangedBlock block;
    for (std::size_t n = 0; n < kMaxBlocks && use->feed->receive(block); ++n)
      if (!use->stream.update(block.origin, block.material.data(), block.fill.data()))
        throw Error("The workpiece has grown beyond this surface; open another surface.");
    SurfaceObject::LentPage& lent = use->free_page();
    if (!use->stream.next_page(lent.page)) return HAPTICUT_NOTHING;
    lent.ticket = ++use->tickets;
    hapticut_page own{};
    put_page(lent, use->stream.frame(), own);
    write_struct(own, page);
    return HAPTICUT_OK;
  });
}

int hapticut_surface_release_page(hapticut_surface surface, uint64_t ticket) {
  return within(Use<SurfaceObject>(surface), [&](const auto& use) -> int {
    const auto found =
        std::find_if(use->pages.begin(), use->pages.end(), [&](const auto& one) { return one->ticket == ticket; });
    if (ticket == 0 || found == use->pages.end())
      return fail(HAPTICUT_ERROR_ARGUMENT, "No page in use has this ticket.");
    (*found)->ticket = 0;
    return HAPTICUT_OK;
  });
}

int hapticut_surface_look_at(hapticut_surface surface, const double* p_WQ) {
  return within(Use<SurfaceObject>(surface), [&](const auto& use) {
    require_argument(p_WQ, "p_WQ");
    use->stream.look_at(vector_of(p_WQ));
  });
}

int hapticut_surface_catch_up(hapticut_surface surface) {
  return within(Use<SurfaceObject>(surface), [&](const auto& use) {
    return within(IdleStay(*use->simulation), [&](const auto&) {
      for (ChangedBlock old; use->feed->receive(old);) {  // these are older than the update below
      }
      const Workpiece& workpiece = use->simulation->simulation.workpiece();
      for_each_block_origin(use->bounds, [&](const VoxelIndex& origin) {
        (void)use->stream.update(workpiece, {&origin, 1});  // all blocks are within its bounds
      });
    });
  });
}

}  // extern "C"
