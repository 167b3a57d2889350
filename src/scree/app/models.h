// The list of models: every name that a case may choose and what it stands for, one line per model.
#pragma once

#include <string>

#include "scree/data/vertices.h"
#include "scree/particles/fields.h"
#include "scree/physics/drag/body/body.h"
#include "scree/physics/drag/crowded.h"

namespace scree {

inline BodyForce body_force(const std::string& name) {
  if (name == "uniform") return BodyForce::uniform;
  if (name == "central") return BodyForce::central;
  if (name == "expression") return BodyForce::expression;
  if (name == "rotating") return BodyForce::rotating;
  return BodyForce::none;
}

inline FlowKind flow_kind(const std::string& name) {
  if (name == "still") return FlowKind::still;
  if (name == "uniform") return FlowKind::uniform;
  if (name == "taylor_green") return FlowKind::taylor_green;
  if (name == "shear") return FlowKind::shear;
  if (name == "expression") return FlowKind::expression;
  return FlowKind::none;
}

inline int drag_law(const std::string& name) {
  if (name == "stokes") return SC_DRAG_STOKES;
  if (name == "schiller_naumann") return SC_DRAG_SCHILLER_NAUMANN;
  if (name == "ergun") return SC_DRAG_ERGUN;
  if (name == "wen_yu") return SC_DRAG_WEN_YU;
  if (name == "gidaspow") return SC_DRAG_GIDASPOW;
  if (name == "gidaspow_blend") return SC_DRAG_GIDASPOW_BLEND;
  if (name == "di_felice") return SC_DRAG_DI_FELICE;
  if (name == "beetstra") return SC_DRAG_BEETSTRA;
  if (name == "syamlal_obrien") return SC_DRAG_SYAMLAL_OBRIEN;
  return SC_DRAG_NONE;
}

/// Drag by shape; of Zastawny's two shapes the first stands for both.
inline int body_drag_law(const std::string& name) {
  if (name == "stokes_ellipsoid") return SC_DRAG_STOKES_ELLIPSOID;
  if (name == "haider_levenspiel") return SC_DRAG_HAIDER_LEVENSPIEL;
  if (name == "ganser") return SC_DRAG_GANSER;
  if (name == "holzer_sommerfeld") return SC_DRAG_HOLZER_SOMMERFELD;
  if (name == "zastawny") return SC_DRAG_ZASTAWNY_5_2;
  return SC_DRAG_NONE;
}

inline VertexSpacing vertex_spacing(const std::string& name) {
  if (name == "exponential") return VertexSpacing::exponential;
  if (name == "radial") return VertexSpacing::radial;
  if (name == "normal") return VertexSpacing::normal;
  if (name == "mixed") return VertexSpacing::mixed;
  return VertexSpacing::linear;
}

inline int integrator(const std::string& name) {
  if (name == "explicit") return SC_EXPLICIT;
  if (name == "implicit") return SC_IMPLICIT;
  return SC_LEAPFROG;
}

}  // namespace scree
