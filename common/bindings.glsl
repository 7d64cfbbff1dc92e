// Where shaders and programs meet: every unit and binding point of the series by its name, GLSL and C++. What is bound
// is bound where it is used, each time anew: no pass relies on what another has left behind.

// Uniform blocks
#define WEATHER_BLOCK 0
#define CAMERA_BLOCK 1
#define LIGHT_BLOCK 2

// Buffers that shaders write
#define FEEDBACK_BUFFER 0   // transform feedback
#define LEDGER_BUFFER 0     // atomic counters
#define FLAKES_BUFFER 0     // shader storage
#define COVER_BUFFER 1      // shader storage
#define SUMS_BUFFER 2       // shader storage
#define DISTANCES_BUFFER 3  // shader storage
#define ORDER_BUFFER 4      // shader storage

// Texture units
#define CRYSTALS_UNIT 0  // what flakes look like
#define POSITION_AGE_UNIT 1
#define VELOCITY_REST_UNIT 2
#define VOXELS_UNIT 3
#define TRIANGLES_UNIT 3  // instead of voxels
#define DEPTH_UNIT 4      // of the snow
#define WIND_X_UNIT 5
#define WIND_Z_UNIT 6
#define SHADOW_UNIT 7
#define SKY_SEEN_UNIT 8
#define PICTURE_UNIT 9  // of a surface of the scene
#define SNOW_UNIT 10    // the snow, smooth
#define GRAIN_UNIT 11   // of it
#define FRAME_UNIT 12   // its light
#define FRAME_DEPTH_UNIT 13
#define GLOW_UNIT 14
#define TERRAIN_UNIT 15  // how high the ground stands

// Image units
#define DEPTH_IMAGE 0
#define SNOW_IMAGE 1
#define VOXELS_IMAGE 0
