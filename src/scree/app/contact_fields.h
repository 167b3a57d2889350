// The fields of a file of contacts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scree/output/frames.h"
#include "scree/particles/sample.h"

namespace scree {

/// A column for every field of all contacts of a sample that has their forces. The columns own their values.
std::vector<FrameColumn> contact_columns(const Sample& sample);

/// The order of the rows among those of all ranks: pairs, then walls. All ids are below `next_id`.
std::vector<RowKey> contact_keys(std::span<const FrameColumn> columns, std::int64_t next_id);

/// Bytes that one contact takes in a file, uncompressed, the list of vertices included.
std::size_t file_bytes_per_contact();

}  // namespace scree
