// Surfaces of shapes that programs for pictures do not know: Wavefront OBJ files beside the frames.
#pragma once

#include <filesystem>

#include "scree/data/form_mesh.h"

namespace scree {

/// The file of form number `form` in a run directory.
std::filesystem::path shape_file(const std::filesystem::path& directory, std::size_t form);

/// Writes the surface of a form over its half axes. Throws ResourceError.
void write_shape_file(const std::filesystem::path& path, const Form& form);

}  // namespace scree
