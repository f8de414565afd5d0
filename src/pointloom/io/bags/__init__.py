"""Recordings of ROS and MCAP.

Messages are decoded by `rosbags` (extra `ros`). Containers are parsed here, so that truncated files are read up to the
damage, memory is bounded by the file, and topics are listed without the extra. The readers of rosbags 0.11.9 and mcap
1.6.0 were tried on 417 files: those that the tests write, truncated ones, and ones with a flipped bit. Complete files
give the same messages (tests/io/test_bags.py). Files that show why they do not replace a module of this package:

bag1 (`rosbags.rosbag1.Reader`): 52 of 123 bags give fewer messages.
    Without the list of chunks at the end, such as after a killed recorder: no messages instead of all.
    A list of chunks that contradicts the messages: no error. An index that does: AssertionError, or none with -O.
    A chunk of 112 bytes of bz2 that claims 1,000 bytes: 269 MB of memory. Its lz4 decoder has no limit either.
    A position of the index that is wrong by its header: 1 GB of memory for a bag of 1.6 kB.
mcap (`mcap.reader.make_reader`, `mcap.stream_reader.StreamReader`): 47 and 16 of 206 files give fewer messages.
    A chunk with a wrong checksum and no index, read with `validate_crcs=True`: its messages, without an error.
    A schema in a chunk whose record claims 17 TB, or an index record without a chunk: messages without an error.
    An index or statistics that contradict the messages: no error.
    A chunk that claims 1 GB of data in a file of 400 bytes: 1 GB of memory. `StreamReader` reads all to list topics.
mcap (`rosbags.rosbag2.storage_mcap.McapReader`): 58 of 206 files give fewer messages.
    No message of a truncated file, or of a file whose profile is not "ros2", as of recorders other than ROS.
db3 (`rosbags.rosbag2.storage_sqlite3.Sqlite3Reader`): 29 of 88 files give fewer messages.
    A file cut in half: no messages instead of 26. A time of text: a message with a time that is no number.
    A table with a computed column: 286 MB of memory for a file of 12 kB.
clouds (`Typestore.deserialize_cdr`): a Livox cloud of 20,000 points takes 19 ms as objects, 0.1 ms as an array.
"""
