// mayfly doctor
#pragma once

namespace mayfly::app {

// Returns the exit code: 0, whatever is missing; a swarm may do without it.
int doctor();

}  // namespace mayfly::app
