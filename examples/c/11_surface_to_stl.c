/* SPDX-License-Identifier: Apache-2.0 */
/* Cuts a groove along the path of a scene, and writes its surface page by page, as a screen would draw it:
 *   11_surface_to_stl [FILE.stl] */
#include <hapticut/c/hapticut.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static const char scene[] =
    "[workpiece]\nsource = 'block'\nsize_mm = [8, 6, 3]\nvoxel_mm = 0.1\nmaterial = 'dentin'\n"
    "[tool]\nhead = 'sphere'\nradius_mm = 1\nhandle = 'ray'\nhandle_length_mm = 20\nspindle_rpm = 40000\n"
    "[path]\nkind = 'line'\npoint = 'tip'\nfrom_mm = [-2, 3, 2.4]\nto_mm = [10, 3, 2.4]\nfeed_mm_per_s = 12\n";

static void must(int code) {
  if (code >= 0) return;
  fprintf(stderr, "%s\n", hapticut_last_error());
  exit(1);
}

/** Position of a vertex in W [m]. */
static void place(const hapticut_page* page, uint16_t index, double* p_W) {
  const int16_t* steps = page->vertices[index].position;
  int row;
  for (row = 0; row < 3; ++row) {
    const double* r = page->X_WP.rotation + 3 * row;
    p_W[row] = page->X_WP.position[row] + page->step * (r[0] * steps[0] + r[1] * steps[1] + r[2] * steps[2]);
  }
}

static uint32_t write_page(FILE* file, const hapticut_page* page) {
  uint32_t n, corner;
  for (n = 0; n < page->index_count; n += 3) {
    fputs("facet normal 0 0 0\nouter loop\n", file); /* STL readers compute the normal from the corners */
    for (corner = 0; corner < 3; ++corner) {
      double p_W[3];
      place(page, page->indices[n + corner], p_W);
      fprintf(file, "vertex %.9g %.9g %.9g\n", 1e3 * p_W[0], 1e3 * p_W[1], 1e3 * p_W[2]); /* mm */
    }
    fputs("endloop\nendfacet\n", file);
  }
  return page->index_count / 3;
}

int main(int argc, char** argv) {
  FILE* file = fopen(argc > 1 ? argv[1] : "groove.stl", "w");
  hapticut_scene_info info = {.struct_size = sizeof info};
  hapticut_step_input input = {.struct_size = sizeof input};
  hapticut_step_result result = {.struct_size = sizeof result};
  hapticut_page page = {.struct_size = sizeof page};
  hapticut_simulation simulation;
  hapticut_surface surface;
  uint32_t triangles = 0, pages = 0;
  double time, removed = 0;
  if (file == NULL) return 1;
  must(hapticut_simulation_from_toml(scene, NULL, &simulation));
  must(hapticut_scene(simulation, &info));
  must(hapticut_surface_open(simulation, &surface));
  input.dt = 1 / info.rate;
  input.linear_velocity[0] = 12e-3;
  for (time = 0; time < info.path_duration; time += input.dt) {
    must(hapticut_path_pose(simulation, time, &input.X_WH));
    must(hapticut_step(simulation, &input, &result));
    removed += result.removed_volume;
  }
  must(hapticut_surface_catch_up(surface)); /* a screen would poll once per picture instead */
  fputs("solid groove\n", file);
  while (hapticut_surface_poll(surface, &page) == HAPTICUT_OK) {
    triangles += write_page(file, &page);
    ++pages;
    must(hapticut_surface_release_page(surface, page.ticket));
  }
  fputs("endsolid groove\n", file);
  if (fclose(file) != 0) return 1;
  printf("removed %.2f mm^3, %u triangles in %u pages\n", 1e9 * removed, (unsigned)triangles, (unsigned)pages);
  must(hapticut_release(surface));
  must(hapticut_release(simulation));
  return 0;
}
