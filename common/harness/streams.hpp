// The standard streams, as whoever started the program left them.
#pragma once

// Opens /dev/null on those that are closed: or the next thing opened, such as the connection to the
// display, would take their number, and what is printed would go there.
void open_standard_streams();

// False, after a line on stderr, if what was printed could not be written.
bool flush_standard_output();
