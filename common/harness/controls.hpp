// What a user may ask of the frame loop, by key or in the panel.
#pragma once

#include <string>

struct Controls {
    bool paused = false;
    bool single_step = false;   // one time step, then pause again
    bool restart = false;       // begin anew, with all buffers as large as they then need to be
    bool save_picture = false;  // of the frame that is next
    bool touring = false;       // on the flight through the courtyard
    std::string note;           // the step's own line, for the panel
};
