#pragma once
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <string_view>

// For each point on a face's border CGAL proves the face's whole triangulation again, in exact numbers: a third of a cut. Its other
// assertions stay, and the proof of the solid follows.
#pragma push_macro("CGAL_assertion")
#undef CGAL_assertion
#define CGAL_assertion(EX)                                                                  \
    (std::string_view(#EX) == "cdt.is_valid()" || CGAL::possibly(EX) ? static_cast<void>(0) \
                                                                     : ::CGAL::assertion_fail(#EX, __FILE__, __LINE__))
#include <CGAL/Polygon_mesh_processing/internal/Corefinement/Visitor.h>
#pragma pop_macro("CGAL_assertion")

#include <CGAL/Polygon_mesh_processing/corefinement.h>
