// Where shaders and programs meet: every unit and binding point of the series by its name, GLSL and C++. What is bound
// is bound where it is used, each time anew: no pass relies on what another has left behind.

// Uniform blocks
#define WEATHER_BLOCK 0
#define GRID_BLOCK 1    // of voxels
#define FRAME_BLOCK 2   // of the winter

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
#define DEPTH_UNIT 4      // of the snow
#define WIND_X_UNIT 5
#define WIND_Z_UNIT 6
#define SHADOW_UNIT 7
#define SKY_VISIBILITY_UNIT 8
#define PICTURE_UNIT 9  // of a surface of the scene
#define SNOW_UNIT 10    // the snow, smooth
#define GRAIN_UNIT 11   // of it
#define FRAME_UNIT 12   // the picture, linear
#define TERRAIN_UNIT 13  // how high the ground stands
#define TRIANGLES_UNIT 14
#define BOXES_UNIT 15  // around triangles
#define HEIGHTS_UNIT 16  // of the scene from above

// Image units
#define DEPTH_IMAGE 0
#define SNOW_IMAGE 1
#define VOXELS_IMAGE 0
