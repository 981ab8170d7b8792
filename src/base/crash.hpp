#pragma once

namespace facet {

// From now on a crash (a segmentation fault, an abort) says a sentence on standard error before it ends the program as
// it would have. Not with sanitizers, which say more.
void sayWhenCrashed();

}  // namespace facet
