// How a layer is drawn. VTK: .cpp files only.
#pragma once

#include <vtkRenderer.h>

namespace abstand::ui {

/// Opaque bodies, then translucent ones blended in their order. VTK would sort translucent pixels with two
/// more pictures of the whole view, which costs more than all bodies where the processor draws.
void drawPlainly(vtkRenderer* renderer);

}  // namespace abstand::ui
