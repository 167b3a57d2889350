// The particle fields of the frames: what there is, and what a case chooses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scree/input/case.h"
#include "scree/output/frames.h"
#include "scree/particles/sample.h"

namespace scree {

/// Which fields that not every case has are there.
struct FrameParts {
  bool agglomerates = false, shapes = false;
  bool others = false;  // some shapes are no superellipsoids
  bool heat = false;    // particles have a temperature
};

/// Values for the frames, in the order of ids.
struct FrameData {
  std::vector<std::int64_t> id;
  std::vector<double> position, velocity, angular_velocity, diameter, mass;
  std::vector<std::int32_t> material, group;
  std::vector<std::int64_t> agglomerate;
  std::vector<std::int32_t> agglomerate_size;
  std::vector<double> orientation, half_axes, exponents;  // empty if all particles are spheres
  std::vector<std::int32_t> shape_file;                   // empty if all are superellipsoids
  std::vector<double> temperature;                        // empty if particles have none
  std::vector<double> force, unwrapped_position, effect_diameter;
  std::vector<std::int32_t> contacts;
  FrameParts there;
};

/// All fields of the sample; those of agglomerates, which take a search of the whole, only if asked for.
FrameData frame_data(const Sample& sample, bool agglomerates);

/// For ranks that leave a frame to another one: no rows, of the same fields.
FrameData no_frame_data(FrameParts there);

/// The order of the rows.
std::vector<RowKey> keys_of(const FrameData& data);

/// The columns that the case chooses with output.fields, in the precision of output.precision. They borrow from `data`
/// or own their values.
std::vector<FrameColumn> frame_columns(const FrameData& data, const OutputKeys& output);

Compression compression_of(const OutputKeys& output);

/// Bytes that the chosen fields of one particle take in a frame, uncompressed, the list of vertices included.
std::size_t frame_bytes_per_particle(const OutputKeys& output, FrameParts there);

/// The names of all fields that there are.
std::vector<std::string> frame_field_names();

}  // namespace scree
